// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "hal/stm32f4/registers/usart.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// A serial port and its interrupt, RM0090 section 30: one byte in the shift register, one waiting in DR, each way.
class FakeUsart {
 public:
  registers::Usart port{};
  registers::Register set_pending{};  ///< NVIC_ISPR1, in which USART1 is bit 5
  std::function<void()> handler{};    ///< empty: somebody asks interrupts()
  std::string wire{};                 ///< what has left it
  bool is_emulated = false;           ///< as QEMU 7.2: every byte leaves at once, and that interrupts nobody
  std::uint32_t handler_calls = 0;

  explicit FakeUsart(RegisterWorld& world) {
    world.on_write(set_pending, [this](std::uint32_t bits) { pended_ = pended_ || (bits >> 5U & 1U) != 0; });
    world.on_read(port.sr, [this] {
      status_was_read_ = true;
      return (waiting_ ? 0U : 0x80U) | (arrived_ ? 0x20U : 0U) | (overrun_ ? 8U : 0U);
    });
    world.on_read(port.dr, [this] {
      arrived_ = false;
      overrun_ = overrun_ && !status_was_read_;
      status_was_read_ = false;
      return std::uint32_t{data_};
    });
    world.on_write(port.dr, [this](std::uint32_t value) {
      const char byte = static_cast<char>(value);
      if (!is_on(13) || !is_on(3)) {
        return;
      }
      if (is_emulated) {
        wire += byte;
      } else if (!shifting_) {
        shifting_ = byte;
      } else {
        waiting_ = byte;  // over whatever was there: that byte is lost
      }
    });
  }

  /// The time of one byte on the wire, and the interrupts in it.
  void pass_byte() {
    if (shifting_) {
      wire += *shifting_;
      shifting_ = waiting_;
      waiting_.reset();
    }
    serve();
  }
  /// A byte comes in; whether the handler gets round to it before the next one is the caller's choice.
  void arrive(std::uint8_t byte) {
    if (!is_on(13) || !is_on(2)) {
      return;
    }
    if (arrived_) {
      overrun_ = true;
    } else {
      data_ = byte;
      arrived_ = true;
    }
  }
  /// An overrun that shows when its byte has just been read.
  void lose_one() { overrun_ = true; }

  void serve() {
    for (int calls = 0; calls < 100 && handler && interrupts(); ++calls) {
      pended_ = false;
      handler_calls += 1;
      handler();
    }
  }
  [[nodiscard]] bool interrupts() const {
    return pended_ || (is_on(5) && (arrived_ || overrun_)) || (!is_emulated && is_on(7) && !waiting_);
  }
  [[nodiscard]] double baud(double bus_hz) const { return bus_hz / RegisterWorld::peek(port.brr); }

 private:
  [[nodiscard]] bool is_on(unsigned bit) const { return (RegisterWorld::peek(port.cr1) >> bit & 1U) != 0; }

  bool pended_ = false;
  std::optional<char> shifting_;
  std::optional<char> waiting_;
  std::uint8_t data_ = 0;
  bool arrived_ = false;
  bool overrun_ = false;
  bool status_was_read_ = false;
};

}  // namespace fantail::hal::stm32f4::test
