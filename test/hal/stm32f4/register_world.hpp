// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::test {

/// What stands behind the registers of one test: memory, unless the test puts a device there. The drivers reach it
/// through registers::load() and store(). One lives at a time.
class RegisterWorld {
 public:
  using OnRead = std::function<std::uint32_t()>;
  using OnWrite = std::function<void(std::uint32_t)>;

  RegisterWorld();
  ~RegisterWorld();
  RegisterWorld(const RegisterWorld&) = delete;
  RegisterWorld& operator=(const RegisterWorld&) = delete;

  /// From now on a read of this register asks the device, and a write tells it.
  void on_read(const registers::Register& place, OnRead device) { reads_[&place] = std::move(device); }
  void on_write(const registers::Register& place, OnWrite device) { writes_[&place] = std::move(device); }

  /// Past all devices: what the memory holds.
  [[nodiscard]] static std::uint32_t peek(const registers::Register& place);
  static void poke(registers::Register& place, std::uint32_t value);

  /// Of all registers, since the beginning.
  [[nodiscard]] std::uint64_t accesses() const { return accesses_; }

 private:
  friend std::uint32_t registers::load(const volatile std::uint32_t&);
  friend void registers::store(volatile std::uint32_t&, std::uint32_t);
  std::map<const volatile void*, OnRead> reads_;
  std::map<const volatile void*, OnWrite> writes_;
  std::uint64_t accesses_ = 0;
};

}  // namespace fantail::hal::stm32f4::test
