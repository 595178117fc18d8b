// SPDX-License-Identifier: MIT
#include "fake_kx134.hpp"

#include <algorithm>
#include <cmath>

namespace fantail::hal::stm32f4::test {
namespace {

constexpr std::uint8_t output = 0x08, command_test_response = 0x12, who_am_i = 0x13, interrupt_source_2 = 0x17,
                       control_1 = 0x1B, control_2 = 0x1C, output_rate = 0x21;

}  // namespace

void FakeKx134::reset() {
  resets += 1;
  registers_.fill(0);
  registers_[control_2] = 0x3F;
  registers_[output_rate] = 0x06;
  reset_until_ = clock_.time + Microseconds{2'000};
  samples_ = 0;
}

void FakeKx134::update() {
  const std::uint8_t control = registers_[control_1];
  if ((control & 0x80U) == 0 || frozen) {
    return;
  }
  // 0.78125 Hz, doubled with each number; the first sample comes after the start-up time, here 2 ms and a period.
  const double rate_hz = 0.78125 * (1U << (registers_[output_rate] & 0x0FU));
  const double on_s = static_cast<double>((clock_.time - switched_on_).count()) * 1e-6 - 0.002;
  const auto due = static_cast<std::int64_t>(std::max(0.0, on_s * rate_hz));
  if (due <= samples_) {
    return;
  }
  samples_ = due;
  if ((control & 0x20U) != 0) {
    registers_[interrupt_source_2] |= 0x10;
  }
  const double full_scale_g = 8 << (control >> 3U & 3U);
  for (std::uint8_t i = 0; i < 3; ++i) {
    const double noise = noisy ? static_cast<double>(samples_ % (3 + i)) : 0.0;
    const double counts = std::clamp(std::round(force_g[i] / full_scale_g * 32768.0) + noise, -32768.0, 32767.0);
    const auto word = static_cast<std::uint16_t>(static_cast<std::int16_t>(counts));
    registers_[output + 2U * i] = static_cast<std::uint8_t>(word);
    registers_[output + 2U * i + 1U] = static_cast<std::uint8_t>(word >> 8U);
  }
}

void FakeKx134::spoken_to() {
  if (clock_.time < reset_until_ && resets > 1) {
    violations.emplace_back("spoken to within 2 ms of its reset");
  }
}

std::uint8_t FakeKx134::read(std::uint8_t address) {
  if (address == who_am_i) {
    return id;
  }
  if (address == command_test_response) {
    return test_response;
  }
  if (address >= output && address < output + 6) {
    registers_[interrupt_source_2] = static_cast<std::uint8_t>(registers_[interrupt_source_2] & ~0x10U);
  }
  return registers_[address];
}

void FakeKx134::write(std::uint8_t address, std::uint8_t value) {
  const bool on = (registers_[control_1] & 0x80U) != 0;
  if (address == control_2 && (value & 0x80U) != 0) {
    reset();
    return;
  }
  if (address == output_rate && on) {
    violations.emplace_back("rate changed while it was on");
  }
  if (address == control_1 && !on && (value & 0x80U) != 0) {
    switched_on_ = clock_.time;
    samples_ = 0;
  }
  registers_[address] = value;
}

}  // namespace fantail::hal::stm32f4::test
