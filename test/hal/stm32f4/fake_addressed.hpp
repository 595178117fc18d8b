// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fake_spi.hpp"

namespace fantail::hal::stm32f4::test {

/// What both inertial sensors do on the wire: the first byte is an address of 7 bits under a bit that says read, and
/// with each byte after it the address goes on by one.
class AddressedSlave : public SpiSlave {
 public:
  std::optional<std::uint8_t> stuck_at{};  ///< answers nothing but this
  /// What a disturbance makes of the answer with which this address is read.
  std::function<std::uint8_t(std::uint8_t address, std::uint8_t answer)> disturbance{};
  /// What must not be done to this device, and was.
  std::vector<std::string> violations{};

  void selected() final {
    address_.reset();
    update();
  }
  void deselected() final {}
  std::uint8_t exchange(std::uint8_t out) final {
    if (stuck_at) {
      return *stuck_at;
    }
    spoken_to();
    if (!address_) {
      address_ = out & 0x7FU;
      reading_ = (out & 0x80U) != 0;
      return 0;
    }
    const std::uint8_t address = *address_;
    address_ = static_cast<std::uint8_t>((address + 1U) & 0x7FU);
    if (reading_) {
      const std::uint8_t answer = read(address);
      return disturbance ? disturbance(address, answer) : answer;
    }
    write(address, out);
    return 0;
  }

 protected:
  /// Time has passed.
  virtual void update() = 0;
  /// May it be? Notes a violation.
  virtual void spoken_to() = 0;
  virtual std::uint8_t read(std::uint8_t address) = 0;
  virtual void write(std::uint8_t address, std::uint8_t value) = 0;

 private:
  std::optional<std::uint8_t> address_;
  bool reading_ = false;
};

}  // namespace fantail::hal::stm32f4::test
