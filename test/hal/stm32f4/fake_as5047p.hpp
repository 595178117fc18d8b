// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include "fake_spi.hpp"

namespace fantail::hal::stm32f4::test {

/// An AS5047P: frames of 16 bits with even parity, and each answer belongs to the frame before.
class FakeAs5047p final : public SpiSlave {
 public:
  std::uint16_t angle = 0;
  std::uint16_t diagnosis = 0x0180;  ///< offsets ready, gain in the middle

  // ---- faults ----
  std::optional<std::uint8_t> stuck_at{};  ///< the line is held at this
  std::uint16_t spoil_answers = 0;         ///< these bits of every answer are turned over
  std::uint16_t spoil_next_command = 0;    ///< these bits of the next frame arrive turned over

  int error_reads = 0;
  int diagnosis_reads = 0;

  [[nodiscard]] Needs needs() const override { return {.modes = {1}, .most_hz = 10'000'000, .select_ns = 350}; }

  void selected() override {
    bits_ = 0;
    command_ = 0;
    answer_ = static_cast<std::uint16_t>(
        with_parity(static_cast<std::uint16_t>(content_ | (errors_ != 0 ? 0x4000U : 0U))) ^ spoil_answers);
    if (errors_were_read_) {
      errors_ = 0;
      errors_were_read_ = false;
    }
  }
  std::uint8_t exchange(std::uint8_t out) override {
    command_ = static_cast<std::uint16_t>(command_ << 8U | out);
    const auto in = static_cast<std::uint8_t>(bits_ == 0 ? answer_ >> 8U : answer_);
    bits_ += 8;
    return stuck_at.value_or(in);
  }
  void deselected() override {
    command_ ^= spoil_next_command;
    spoil_next_command = 0;
    if (bits_ != 16) {
      errors_ |= 1;  // FRERR
    } else if (std::popcount(command_) % 2 != 0) {
      errors_ |= 4;  // PARERR
    } else {
      obey();
    }
  }

 private:
  static std::uint16_t with_parity(std::uint16_t frame) {
    return std::popcount(frame) % 2 == 0 ? frame : static_cast<std::uint16_t>(frame | 0x8000U);
  }
  void obey() {
    switch (command_ & 0x7FFF) {
      case 0x4001:
        content_ = errors_;
        errors_were_read_ = true;
        error_reads += 1;
        break;
      case 0x7FFC:
        content_ = diagnosis;
        diagnosis_reads += 1;
        break;
      case 0x7FFF: content_ = angle & 0x3FFFU; break;
      default: errors_ |= 2;  // INVCOMM
    }
  }

  int bits_ = 0;
  std::uint16_t command_ = 0;
  std::uint16_t answer_ = 0;
  std::uint16_t content_ = 0;
  std::uint16_t errors_ = 0;
  bool errors_were_read_ = false;
};

}  // namespace fantail::hal::stm32f4::test
