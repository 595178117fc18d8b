// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hal/board.hpp"
#include "hal/clock.hpp"
#include "hal/flash.hpp"
#include "hal/stm32f4/spi_bus.hpp"

namespace fantail::hal::stm32f4 {

/// W25Q128JV, or a smaller one of its family (down to 1 MiB). A program or an erase is begun and goes on by itself;
/// that the device is busy is asked of the device, at each call.
class Flash final : public hal::Flash {
 public:
  /// The bus of the device and the clock outlive this object.
  Flash(SpiDevice device, const hal::Clock& clock) : device_{device}, clock_{clock} {}

  /// At boot, before anything else: some tens of microseconds, and no more. A processor that was reset in the middle of
  /// an erase finds a device that answers nothing but its status for up to 400 ms, which a flight cannot wait for: it
  /// is taken for the W25Q128 this board is built with, and asked for its name at the first call that finds it idle.
  void start();

  [[nodiscard]] FlashGeometry geometry() const override { return geometry_; }
  FlashResult read(std::uint32_t address, std::span<std::byte> out) override;
  FlashResult program(std::uint32_t address, std::span<const std::byte> bytes) override;
  FlashResult erase_sector(std::uint32_t address) override;
  [[nodiscard]] bool busy() override;

  /// What is wrong now.
  [[nodiscard]] BoardFaults faults() const;

 private:
  enum class State : std::uint8_t {
    absent,   ///< nothing there, or not what belongs there
    unnamed,  ///< it was busy at boot
    ready,
    write_protected,  ///< it can be read; its protection bits cannot be cleared
  };

  bool command(std::byte instruction) { return device_.transfer(std::array{instruction}, {}); }
  std::optional<std::uint8_t> status(std::byte instruction);
  /// Empty when it does not answer; remembers for how long it has been busy.
  std::optional<bool> poll();
  bool identify();
  bool clear_protection();
  std::optional<FlashResult> refusal(bool in_range);
  std::optional<FlashResult> write_refusal(bool in_range);
  void begin(Microseconds longest);
  [[nodiscard]] bool inside(std::uint32_t address, std::size_t size) const {
    return address < geometry_.size && size <= geometry_.size - address;
  }

  SpiDevice device_;
  const hal::Clock& clock_;
  State state_ = State::absent;
  FlashGeometry geometry_{};
  bool silent_ = false;
  bool wrong_id_ = false;
  bool stuck_ = false;
  Microseconds busy_since_{};
  Microseconds may_be_busy_for_{};
};

}  // namespace fantail::hal::stm32f4
