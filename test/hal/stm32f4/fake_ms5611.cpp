// SPDX-License-Identifier: MIT
#include "fake_ms5611.hpp"

#include <algorithm>
#include <cmath>

namespace fantail::hal::stm32f4::test {
namespace {

/// By oversampling, 256 to 4096: the longest that a conversion takes.
constexpr std::array<std::int64_t, 5> conversion_us{600, 1'170, 2'280, 4'540, 9'040};

/// What the compensation makes of a result of the thermometer, and the other way round, in real numbers.
struct Compensation {
  const FakeMs5611::Constants& c;
  bool is_ms5607;

  [[nodiscard]] double first_order(double dt) const { return 2000.0 + dt * c[6] / 8388608.0; }
  [[nodiscard]] double temperature(double dt) const {
    const double first = first_order(dt);
    return first < 2000.0 ? first - dt * dt / 2147483648.0 : first;
  }
  [[nodiscard]] double dt(double temperature_c) const {
    double low = -4e6, high = 4e6;
    while (high - low > 1e-3) {
      const double middle = (low + high) / 2;
      (temperature(middle) < 100.0 * temperature_c ? low : high) = middle;
    }
    return low;
  }
  [[nodiscard]] double pressure_counts(double pressure_pa, double dt) const {
    double off = c[2] * 65536.0 + c[4] * dt / 128.0;
    double sens = c[1] * 32768.0 + c[3] * dt / 256.0;
    const double temp = first_order(dt);
    const double below_20 = std::min(temp - 2000.0, 0.0), below_minus_15 = std::min(temp + 1500.0, 0.0);
    if (is_ms5607) {  // of the same words twice as much, and another correction in the cold
      off = 2.0 * off - 3.8125 * below_20 * below_20 - 15.0 * below_minus_15 * below_minus_15;
      sens = 2.0 * sens - 2.0 * below_20 * below_20 - 8.0 * below_minus_15 * below_minus_15;
    } else {
      off -= 2.5 * below_20 * below_20 + 7.0 * below_minus_15 * below_minus_15;
      sens -= 1.25 * below_20 * below_20 + 5.5 * below_minus_15 * below_minus_15;
    }
    return (pressure_pa * 32768.0 + off) * 2097152.0 / sens;
  }
};

}  // namespace

FakeMs5611::FakeMs5611(const FakeClock& clock)
    : constants{with_crc({0x0000, 40127, 36924, 23317, 23282, 33464, 28312, 0x0000})}, clock_{clock} {}

FakeMs5611::Constants FakeMs5611::with_crc(Constants constants) {
  // x^4 + x + 1 over all bits except those of the last byte.
  std::uint32_t crc = 0;
  for (std::size_t bit = 0; bit < 120; ++bit) {
    const std::uint32_t next = constants[bit / 16] >> (15 - bit % 16) & 1U;
    const std::uint32_t top = crc >> 3U ^ next;
    crc = (crc << 1U & 0xFU) ^ (top != 0 ? 0x3U : 0U);
  }
  constants[7] = static_cast<std::uint16_t>((constants[7] & 0xFFF0U) | crc);
  return constants;
}

void FakeMs5611::lose_power() {
  loaded_at_ = ready_at_ = Microseconds{};
  result_ = 0;
  calibrated_ = false;
  first_ = true;
}

void FakeMs5611::selected() {
  command_.reset();
  answer_.clear();
}

std::uint8_t FakeMs5611::exchange(std::uint8_t out) {
  std::uint8_t in = 0xFE;  // while it gets its command
  if (!command_) {
    command_ = out;
    if (!stuck_at) {
      obey(out);
    }
  } else if (!answer_.empty()) {
    in = answer_.back();
    answer_.pop_back();
  }
  return stuck_at ? *stuck_at : disturbance ? disturbance(in) : in;
}

void FakeMs5611::answer(std::uint32_t value, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i) {
    answer_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
}

void FakeMs5611::obey(std::uint8_t command) {
  if (command == 0x1E) {
    lose_power();
    resets += 1;
    calibrated_ = true;
    loaded_at_ = clock_.time + Microseconds{2'800};
    return;
  }
  if (clock_.time < loaded_at_) {
    violations.emplace_back("spoken to within 2.8 ms of its reset");
    return;
  }
  if (converting()) {
    violations.emplace_back("spoken to during a conversion");
    result_ = result_ / 2 + 1;
    answer(0, 3);
    return;
  }
  if (command == 0x00) {
    answer(result_, 3);
    result_ = 0;
  } else if ((command & 0xF1U) == 0xA0) {
    answer(constants[(command & 0x0EU) / 2], 2);
  } else if (((command & 0xF0U) == 0x40 || (command & 0xF0U) == 0x50) && (command & 0x0FU) <= 8) {
    convert(command);
  } else {
    violations.emplace_back("given a command that it does not know");
  }
}

double FakeMs5611::measured(bool pressure) const {
  const Compensation compensation{constants, is_ms5607};
  const double dt = compensation.dt(temperature_c);
  if (!pressure) {
    return dt + constants[5] * 256.0;
  }
  const double die_pa = blocked_at_pa.value_or(pressure_pa) + light_pa;
  return compensation.pressure_counts(die_pa, dt);
}

void FakeMs5611::convert(std::uint8_t command) {
  conversions += 1;
  const bool pressure = command < 0x50;
  ready_at_ = clock_.time + Microseconds{conversion_us.at((command & 0x0FU) / 2)};
  std::normal_distribution<double> noise{0.0, 1.0};
  const double counts = (measured(pressure) + noise_counts * noise(random_)) * (first_ || !calibrated_ ? 0.97 : 1.0);
  const auto found = static_cast<std::uint32_t>(std::clamp(std::round(counts), 1.0, 16777215.0));
  const auto given = pressure ? pressure_result : temperature_result;
  const bool is_frozen = pressure ? pressure_frozen : temperature_frozen;
  std::uint32_t& frozen = frozen_[pressure ? 0 : 1];
  result_ = never_ready ? 0 : given ? *given : is_frozen && frozen != 0 ? frozen : found;
  frozen = result_;
  first_ = false;
}

}  // namespace fantail::hal::stm32f4::test
