// SPDX-License-Identifier: MIT
#include "fake_ism330dhcx.hpp"

#include <algorithm>
#include <cmath>

namespace fantail::hal::stm32f4::test {
namespace {

constexpr std::uint8_t access = 0x01, who_am_i = 0x0F, accelerometer_control = 0x10, gyro_control = 0x11,
                       control_3 = 0x12, self_test = 0x14, control_9 = 0x18, status = 0x1E, gyro_data = 0x22,
                       accelerometer_data = 0x28;

/// CTRL2_G, bits 3 to 0: mdeg/s a count.
double deg_s_per_count(std::uint8_t control) {
  switch (control & 0x0FU) {
    case 0x1: return 0.140;
    case 0xC: return 0.070;
    case 0x8: return 0.035;
    case 0x4: return 0.0175;
    case 0x2: return 0.004375;
    default: return 0.00875;
  }
}

/// CTRL1_XL, bits 3 and 2.
double g_per_count(std::uint8_t control) {
  constexpr std::array by_range{0.000061, 0.000488, 0.000122, 0.000244};
  return by_range[control >> 2U & 3U];
}

}  // namespace

void FakeIsm330dhcx::reset() {
  resets += 1;
  registers_.fill(0);
  registers_[control_3] = 0x05;  // IF_INC, and the reset itself for as long as it lasts
  registers_[control_9] = 0xE0;
  reset_until_ = clock_.time + Microseconds{1'000};
  samples_ = 0;
}

void FakeIsm330dhcx::update() {
  if (clock_.time >= reset_until_ && !never_ends_reset) {
    registers_[control_3] &= 0xFEU;
  }
  const std::uint8_t rate = registers_[gyro_control] >> 4U;
  if (rate == 0 || stopped) {
    return;
  }
  const double rate_hz = rate == 0xB ? 1.6 : 13.0 * (1U << (rate - 1U));  // 12.5, then 26 and its doubles up to 6667
  const double on_s = static_cast<double>((clock_.time - switched_on_).count()) * 1e-6;
  const auto due = static_cast<std::int64_t>(on_s * rate_hz);
  if (due <= samples_) {
    return;
  }
  samples_ = due;
  registers_[status] |= 0x03;
  const double swings = on_s < 0.07 ? 300.0 : 0.0;  // until its drive is steady
  const bool actuated = (registers_[self_test] >> 2U & 3U) == 1;
  for (std::uint8_t i = 0; i < 3; ++i) {
    const auto at = static_cast<std::uint8_t>(2 * i);
    const double noise = frozen ? 0.0 : noise_counts * static_cast<double>((samples_ + i) % 3 - 1);
    const double turned = rate_deg_s[i] + swings + (actuated ? actuation_deg_s : 0.0);
    put(static_cast<std::uint8_t>(gyro_data + at), turned / deg_s_per_count(registers_[gyro_control]) + noise);
    if ((registers_[accelerometer_control] & 0xF0U) != 0) {
      put(static_cast<std::uint8_t>(accelerometer_data + at),
          force_g[i] / g_per_count(registers_[accelerometer_control]) + noise);
    }
  }
}

void FakeIsm330dhcx::put(std::uint8_t address, double counts) {
  const auto word =
      static_cast<std::uint16_t>(static_cast<std::int16_t>(std::clamp(std::round(counts), -32768.0, 32767.0)));
  registers_[address] = static_cast<std::uint8_t>(word);
  registers_[address + 1U] = static_cast<std::uint8_t>(word >> 8U);
}

std::uint8_t FakeIsm330dhcx::read(std::uint8_t address) {
  if (address == access) {
    return registers_[access];
  }
  if (shows_others()) {
    return 0;
  }
  if (address == who_am_i) {
    return id;
  }
  if (address == control_9 && !shows_device_conf) {
    return registers_[control_9] & 0xFDU;
  }
  if (address == gyro_data + 5) {
    registers_[status] &= 0xFDU;
  }
  const bool torn = (registers_[control_3] & 0x40U) == 0 && address > gyro_data && address % 2 == 1;
  return torn ? static_cast<std::uint8_t>(~registers_[address]) : registers_[address];
}

void FakeIsm330dhcx::write(std::uint8_t address, std::uint8_t value) {
  if (address == access) {
    registers_[access] = value;
    return;
  }
  if (shows_others() || (registers_[control_3] & 1U) != 0) {
    return;
  }
  if (address == control_3 && (value & 1U) != 0) {
    reset();
    return;
  }
  constexpr std::uint8_t fastest_unconfigured = 7;  // 833 Hz
  if (address == accelerometer_control && value >> 4U > fastest_unconfigured && (registers_[control_9] & 2U) == 0) {
    return;
  }
  if (address == gyro_control && registers_[gyro_control] >> 4U == 0 && value >> 4U != 0) {
    switched_on_ = clock_.time;
    samples_ = 0;
  }
  registers_[address] = value;
}

}  // namespace fantail::hal::stm32f4::test
