// SPDX-License-Identifier: MIT
#include "fake_icm42688.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fantail::hal::stm32f4::test {
namespace {

// Bank 0, section 13.1.
constexpr std::uint8_t device_config = 0x11, accelerometer_data = 0x1F, gyro_data = 0x25, interrupt_status = 0x2D,
                       interface_config_1 = 0x4D, power = 0x4E, gyro_config = 0x4F, accelerometer_config = 0x50,
                       self_test = 0x70, who_am_i = 0x75, bank_select = 0x76;

/// Section 5.6: the range is halved with each number.
double range(double widest, std::uint8_t config) { return widest / (1 << (config >> 5U)); }

/// The factory's codes, in counts of 250 deg/s and 2 g full scale.
double factory_counts(std::uint8_t code) { return 2620.0 * std::pow(1.01, code - 1); }

}  // namespace

FakeIcm42688::FakeIcm42688(const FakeClock& clock) : clock_{clock} {
  reset();
  resets = 0;
}

void FakeIcm42688::reset() {
  resets += 1;
  bank_ = 0;
  for (auto& bank : registers_) {
    bank.fill(0);
  }
  auto& bank0 = registers_[0];
  for (std::uint8_t address = 0x1D; address <= gyro_data + 5; address += 2) {
    bank0[address] = 0x80;  // -32768 until the first sample
  }
  bank0[interrupt_status] = 0x10;
  bank0[0x4C] = 0x30, bank0[interface_config_1] = 0x91, bank0[gyro_config] = 0x06, bank0[accelerometer_config] = 0x06;
  bank0[0x51] = 0x16, bank0[0x52] = 0x11, bank0[0x53] = 0x0D, bank0[0x64] = 0x10, bank0[0x65] = 0x10;
  std::ranges::copy(gyro_codes, registers_[1].begin() + 0x5F);
  std::ranges::copy(accelerometer_codes, registers_[2].begin() + 0x3B);
  reset_until_ = clock_.time + Microseconds{1'000};
  samples_ = 0;
  fast_ = {};
  stuck_until_ = {};
}

void FakeIcm42688::update() {
  const std::uint8_t mode = registers_[0][power];
  const bool gyro_on = (mode & 0x0CU) == 0x0C;
  const bool accelerometer_on = (mode & 0x03U) == 0x03;
  if ((!gyro_on && !accelerometer_on) || frozen) {
    return;
  }
  // Both at 1 kHz; the slower to start sets the beat.
  const Microseconds first =
      std::max(gyro_on ? gyro_ready_ : Microseconds{}, accelerometer_on ? accelerometer_ready_ : Microseconds{});
  const auto time_of = [&](std::int64_t sample) {
    return first + Microseconds{std::llround(static_cast<double>(sample) * period_us)};
  };
  const std::int64_t seen = samples_;
  while (time_of(samples_) <= clock_.time) {
    samples_ += 1;
  }
  if (samples_ == seen) {
    return;
  }
  const Microseconds time = time_of(samples_ - 1);
  if (before_sample) {
    before_sample(time);
  }
  raise_interrupt_1(time, samples_ - seen);
  registers_[0][interrupt_status] |= 0x08;
  const std::uint8_t test = registers_[0][self_test];
  std::normal_distribution<double> noise;
  for (std::uint8_t i = 0; i < 3; ++i) {
    const auto at = static_cast<std::uint8_t>(2 * i);
    if (gyro_on && !gyro_is_stuck(i)) {
      const bool actuated = (test >> i & 1U) != 0;
      const double more = actuated ? gyro_actuation * factory_counts(gyro_codes[i]) * 250.0 / 32768.0 : 0.0;
      if (!gyro_repeats[i]) {
        held_deg_s_[i] = rate_deg_s[i] + more + gyro_noise_deg_s * noise(random_);
      }
      put(static_cast<std::uint8_t>(gyro_data + at), held_deg_s_[i], range(2000.0, registers_[0][gyro_config]));
    }
    if (accelerometer_on) {
      const bool actuated = (test >> (3U + i) & 1U) != 0 && (test & 0x40U) != 0;
      const double more =
          actuated ? accelerometer_actuation * factory_counts(accelerometer_codes[i]) * 2.0 / 32768.0 : 0.0;
      if (!accelerometer_repeats[i]) {
        held_g_[i] = force_g[i] + more + accelerometer_noise_g * noise(random_);
      }
      put(static_cast<std::uint8_t>(accelerometer_data + at), held_g_[i],
          range(16.0, registers_[0][accelerometer_config]));
    }
  }
}

void FakeIcm42688::raise_interrupt_1(Microseconds time, std::int64_t edges) {
  constexpr std::uint8_t int_config = 0x14, int_config_1 = 0x64, int_source_0 = 0x65;
  const auto& bank0 = registers_[0];
  // Sections 14.3 and 12.6: pulsed, push-pull, active high; INT_ASYNC_RESET off; data-ready alone.
  if ((bank0[int_config] & 7U) == 3 && (bank0[int_config_1] & 0x10U) == 0 && bank0[int_source_0] == 0x08) {
    interrupt_1_ = {time, (interrupt_1_ ? interrupt_1_->number : 0) + edges};
  }
}

std::optional<LineEdge> FakeIcm42688::interrupt_1() {
  update();
  return interrupt_1_;
}

bool FakeIcm42688::gyro_is_stuck(std::uint8_t axis) {
  constexpr double other_range_deg_s = 100.0;
  constexpr std::int64_t stuck_samples = 2;
  const bool fast = std::abs(rate_deg_s[axis]) > other_range_deg_s;
  const bool adapts = (registers_[0][interface_config_1] & 0xC0U) != 0x40;
  if (fast != fast_[axis] && adapts) {
    stuck_until_[axis] = samples_ + stuck_samples;
  }
  fast_[axis] = fast;
  return samples_ < stuck_until_[axis];
}

void FakeIcm42688::put(std::uint8_t address, double value, double full_scale) {
  // Section 14.34, FIFO_HOLD_LAST_DATA_EN = 0: the lowest counts are replaced.
  const double counts = std::clamp(std::round(value / full_scale * 32768.0), -32766.0, 32767.0);
  const auto word = static_cast<std::uint16_t>(static_cast<std::int16_t>(counts));
  registers_[0][address] = static_cast<std::uint8_t>(word >> 8U);
  registers_[0][address + 1U] = static_cast<std::uint8_t>(word);
}

void FakeIcm42688::spoken_to() {
  if (clock_.time < reset_until_ && resets > 0) {
    violations.emplace_back("spoken to within 1 ms of its reset");
  }
}

std::uint8_t FakeIcm42688::read(std::uint8_t address) {
  if (bank_ == 0 && address == who_am_i) {
    return id;
  }
  if (address == bank_select) {
    return bank_;
  }
  if (bank_ == 0 && address == interrupt_status && before_status) {
    std::exchange(before_status, {})();
    update();
  }
  const std::uint8_t value = registers_[bank_][address];
  if (bank_ == 0 && address == interrupt_status) {
    registers_[0][interrupt_status] = 0;
  }
  return value;
}

void FakeIcm42688::write(std::uint8_t address, std::uint8_t value) {
  writes += 1;
  if (clock_.time - switched_on_ < Microseconds{200}) {
    violations.emplace_back("written to within 200 us of being switched on");
  }
  if (address == bank_select) {
    bank_ = value & 7U;
    return;
  }
  const std::uint8_t mode = registers_[0][power];
  const bool any_on = mode != 0;
  const bool may_change = bank_ == 0 && (address == device_config || address == power || address == gyro_config ||
                                         address == accelerometer_config || address == self_test);
  if (any_on && !may_change) {
    violations.emplace_back("a register changed while a sensor was on");
  }
  if (bank_ == 0 && address == device_config && (value & 1U) != 0) {
    reset();
    return;
  }
  if (bank_ == 0 && address == power) {
    if ((mode & 0x0CU) != 0x0C && (value & 0x0CU) == 0x0C) {
      gyro_ready_ = clock_.time + Microseconds{30'000};
    }
    if ((mode & 0x03U) != 0x03 && (value & 0x03U) == 0x03) {
      accelerometer_ready_ = clock_.time + Microseconds{10'000};
    }
    if (mode == 0 && value != 0) {
      switched_on_ = clock_.time;
    }
    if (mode != value) {
      samples_ = 0;
      stuck_until_ = {};
    }
  }
  registers_[bank_][address] = value;
}

}  // namespace fantail::hal::stm32f4::test
