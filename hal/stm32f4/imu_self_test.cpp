// SPDX-License-Identifier: MIT
#include "hal/stm32f4/imu_self_test.hpp"

#include <algorithm>
#include <limits>

#include "hal/stm32f4/icm42688.hpp"
#include "hal/stm32f4/imu_samples.hpp"

namespace fantail::hal::stm32f4 {
namespace {

namespace icm = icm42688;

constexpr std::int32_t samples_wanted = 200;
constexpr Microseconds longest_collection{300'000};

struct Phase {
  std::uint8_t power;
  std::uint8_t test;
  std::uint8_t data;
  Microseconds settle;
};
// One sensor after the other. The gyro's oscillation takes 200 ms to settle when it is disturbed.
constexpr std::array phase_table{
    Phase{icm::gyro_low_noise, 0, icm::gyro_data, Microseconds{60'000}},
    Phase{icm::gyro_low_noise, icm::gyro_self_test, icm::gyro_data, Microseconds{200'000}},
    Phase{icm::accelerometer_low_noise, 0, icm::accelerometer_data, Microseconds{25'000}},
    Phase{icm::accelerometer_low_noise, icm::accelerometer_self_test, icm::accelerometer_data, Microseconds{25'000}}};

constexpr std::int32_t counts_per_deg_s = 32768 / 250;
constexpr std::int32_t counts_per_g = 32768 / 2;

/// What the factory saw, in counts of the ranges above; empty when it noted nothing. A code is a percent more than the
/// one before it, and the first is 2620 counts.
std::optional<float> factory_response(std::uint8_t code) {
  if (code == 0) {
    return std::nullopt;
  }
  float response = 2620.0F;
  for (std::uint8_t i = 1; i < code; ++i) {
    response *= 1.01F;
  }
  return response;
}

/// One axis without a code, and the absolute limits hold for all of them.
bool responses_are_within(const ImuSelfTest::Axes& off, const ImuSelfTest::Axes& on, const ImuSelfTest::Codes& codes,
                          std::int32_t least, std::int32_t most) {
  const bool coded = std::ranges::all_of(codes, [](std::uint8_t code) { return code != 0; });
  for (std::size_t i = 0; i < off.size(); ++i) {
    const std::int32_t response = on[i] > off[i] ? on[i] - off[i] : off[i] - on[i];
    if (!coded) {
      if (response < least || response > most) {
        return false;
      }
    } else if (const float ratio = static_cast<float>(response) / *factory_response(codes[i]);
               ratio <= 0.5F || ratio >= 1.5F) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool ImuSelfTest::gyro_passes(const Axes& off, const Axes& on, const Codes& codes) {
  // A gyro at rest; a rocket that is carried about as it is switched on does not pass either.
  constexpr std::int32_t most_offset = 20 * counts_per_deg_s;
  return std::ranges::all_of(off, [](std::int32_t mean) { return mean >= -most_offset && mean <= most_offset; }) &&
         responses_are_within(off, on, codes, 60 * counts_per_deg_s, std::numeric_limits<std::int32_t>::max());
}

bool ImuSelfTest::accelerometer_passes(const Axes& off, const Axes& on, const Codes& codes) {
  return responses_are_within(off, on, codes, 50 * counts_per_g / 1000, 1200 * counts_per_g / 1000);
}

ImuSelfTest::State ImuSelfTest::step(SpiRegisters& registers, Microseconds now) {
  if (!configured_) {
    configured_ = configure(registers);
    return configured_ ? State::running : State::broken;
  }
  if (!phase_begun_) {
    phase_begun_ = begin_phase(registers, now);
    return phase_begun_ ? State::running : State::broken;
  }
  if (now < settled_at_) {
    return State::running;
  }
  if (now - settled_at_ > longest_collection || !collect(registers)) {
    return State::broken;
  }
  if (samples_ < samples_wanted) {
    return State::running;
  }
  for (std::int32_t& sum : means_[phase_]) {
    sum /= samples_;
  }
  phase_begun_ = false;
  phase_ += 1;
  return phase_ < phases ? State::running : judge(registers);
}

// With both sensors off: section 12.9.
bool ImuSelfTest::configure(SpiRegisters& registers) {
  constexpr std::uint8_t range_3_at_1_khz = 0x66;  // 250 deg/s; 2 g
  return registers.write(icm::bank_select, 0) && registers.write(icm::gyro_config_0, range_3_at_1_khz) &&
         registers.write(icm::accelerometer_config_0, range_3_at_1_khz) &&
         registers.write(icm::gyro_config_1, 0x1A) &&           // filter of third order
         registers.write(icm::accelerometer_config_1, 0x15) &&  // the same
         registers.write(icm::filter_config_0, 0x44);           // a tenth of the rate: 98 Hz
}

bool ImuSelfTest::begin_phase(SpiRegisters& registers, Microseconds now) {
  settled_at_ = now + phase_table[phase_].settle;
  samples_ = 0;
  // Power last: for 200 us after a sensor has been switched on nothing may be written (section 14.36).
  return registers.write(icm::self_test_config, phase_table[phase_].test) &&
         registers.write(icm::power_management_0, phase_table[phase_].power);
}

bool ImuSelfTest::collect(SpiRegisters& registers) {
  const auto status = registers.read(icm::interrupt_status);
  if (!status || (*status & icm::reset_done) != 0) {
    return false;
  }
  std::array<std::byte, 6> data{};
  if ((*status & icm::data_ready) == 0) {
    return true;
  }
  if (!registers.read(phase_table[phase_].data, data)) {
    return false;
  }
  const Counts counts = big_endian_counts(data);
  if (are_valid(counts)) {
    samples_ += 1;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      means_[phase_][i] += counts[i];
    }
  }
  return true;
}

ImuSelfTest::State ImuSelfTest::judge(SpiRegisters& registers) {
  std::array<std::byte, 3> gyro{};
  std::array<std::byte, 3> accelerometer{};
  const bool answered = registers.write(icm::bank_select, 1) && registers.read(icm::gyro_self_test_data, gyro) &&
                        registers.write(icm::bank_select, 2) &&
                        registers.read(icm::accelerometer_self_test_data, accelerometer) &&
                        registers.write(icm::bank_select, 0);
  if (!answered) {
    return State::broken;
  }
  const auto codes = [](const std::array<std::byte, 3>& bytes) {
    Codes result{};
    std::ranges::transform(bytes, result.begin(), [](std::byte byte) { return std::to_integer<std::uint8_t>(byte); });
    return result;
  };
  const bool passed = gyro_passes(means_[0], means_[1], codes(gyro)) &&
                      accelerometer_passes(means_[2], means_[3], codes(accelerometer));
  return passed ? State::passed : State::failed;
}

}  // namespace fantail::hal::stm32f4
