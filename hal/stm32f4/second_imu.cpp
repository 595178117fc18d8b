// SPDX-License-Identifier: MIT
#include "hal/stm32f4/second_imu.hpp"

#include <algorithm>
#include <limits>

#include "hal/stm32f4/ism330dhcx.hpp"

namespace fantail::hal::stm32f4 {
namespace {

namespace ism = ism330dhcx;

// What ST's own examples wait after power-up, and for a stable output.
constexpr Microseconds boot_time{10'000};
constexpr Microseconds stable_time{100'000};
constexpr Microseconds longest_reset{20'000};
constexpr Microseconds longest_collection{50'000};
constexpr Microseconds longest_without_sample{10'000};
constexpr std::uint8_t most_misses = 5;
// It is noisier than its last bit: at work it does not say exactly the same on six axes so often.
constexpr std::uint8_t most_repeats = 50;
constexpr std::uint8_t samples_wanted = 5;

struct Setting {
  std::uint8_t address;
  std::uint8_t value;
};
// Reserved bits keep their reset values.
constexpr auto settings = std::to_array<Setting>({
    {ism::control_3, ism::whole_samples | ism::addresses_go_on},
    {ism::control_4, 0x06},              // the gyro's filter on, no I2C
    {ism::self_test_control, 0x00},      // off
    {ism::gyro_filter, 0x00},            // 292 Hz at this rate; accelerometer in high-performance mode
    {ism::accelerometer_filter, 0x20},   // a tenth of the rate: 333 Hz
    {ism::accelerometer_control, 0x96},  // 3.3 kHz, 16 g, with that filter
    {ism::gyro_control, 0x91},           // 3.3 kHz, 4000 deg/s
});
// The sizes of a count, and where the range of the gyro ends: the counts go on to 4587 deg/s, and nobody says how.
constexpr float deg_s_per_count = 0.140F;
constexpr float g_per_count = 0.000488F;
constexpr std::int16_t end_of_range = 28'571;  // 4000 / 0.14

constexpr std::size_t temperature_size = 2;
constexpr std::size_t burst_size = 16;  // status, a reserved byte, temperature, six axes

Counts little_endian_counts(std::span<const std::byte, 6> bytes) {
  Counts counts{};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto low = std::to_integer<std::uint16_t>(bytes[2 * i]);
    const auto high = std::to_integer<std::uint16_t>(bytes[2 * i + 1]);
    counts[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(high << 8U | low));
  }
  return counts;
}

/// The ends of the range become what hal::Counts calls the ends.
Counts with_true_ends(Counts counts) {
  using Limits = std::numeric_limits<std::int16_t>;
  for (std::int16_t& count : counts) {
    count = count >= end_of_range ? Limits::max() : count <= -end_of_range ? Limits::min() : count;
  }
  return counts;
}

/// Actuated by the sensor itself each axis moves by 150 to 700 deg/s: the limits of ST's example, there at 2000 deg/s
/// and 208 Hz.
bool passes(const std::array<std::int32_t, 3>& at_rest, const std::array<std::int32_t, 3>& actuated) {
  constexpr auto least = static_cast<std::int32_t>(samples_wanted * 150 / deg_s_per_count);
  constexpr auto most = static_cast<std::int32_t>(samples_wanted * 700 / deg_s_per_count);
  for (std::size_t i = 0; i < at_rest.size(); ++i) {
    const std::int32_t moved = actuated[i] > at_rest[i] ? actuated[i] - at_rest[i] : at_rest[i] - actuated[i];
    if (moved < least || moved > most) {
      return false;
    }
  }
  return true;
}

}  // namespace

void SecondImu::start(SensorStart how) {
  stage_ = how == SensorStart::in_flight ? Stage::adopt : Stage::reset;
  tested_ = how == SensorStart::in_flight;
}

ImuSample SecondImu::read() {
  const Microseconds now = clock_.now();
  switch (stage_) {
    case Stage::adopt: adopt(now); break;
    case Stage::reset: reset(); break;
    case Stage::wait_for_reset: wait_for_reset(now); break;
    case Stage::at_rest:
    case Stage::actuated: carry_on_self_test(now); break;
    case Stage::warm_up:
      if (now - since_ >= stable_time) {
        begin(now, Stage::running);
        run(now);
      }
      break;
    case Stage::running: run(now); break;
  }
  return sample_;
}

ImuScale SecondImu::scale() const {
  constexpr float rad_per_deg = 0.017453292519943295F;
  constexpr float g_m_s2 = 9.80665F;
  return {.rate_rad_s = deg_s_per_count * rad_per_deg, .specific_force_m_s2 = g_per_count * g_m_s2};
}

void SecondImu::restart(Status status) {
  sample_.status = status;
  stage_ = Stage::reset;
}

void SecondImu::begin(Microseconds now, Stage stage) {
  stage_ = stage;
  since_ = last_new_ = now;
  misses_ = repeats_ = samples_ = 0;
  sum_ = {};
}

void SecondImu::adopt(Microseconds now) {
  // The processor may have been reset while other registers were shown.
  if (registers_.write(ism::access, 0) && registers_.read(ism::who_am_i) == ism::id && is_configured()) {
    begin(now, Stage::running);
  } else {
    restart(Status::no_reading);
  }
}

void SecondImu::reset() {
  if (registers_.write(ism::access, 0) && registers_.write(ism::control_3, ism::soft_reset | ism::addresses_go_on)) {
    begin(clock_.now(), Stage::wait_for_reset);  // from the end of the command on
  }
}

void SecondImu::wait_for_reset(Microseconds now) {
  if (now - since_ < boot_time) {
    return;
  }
  const auto id = registers_.read(ism::who_am_i);
  const bool is_reset = id == ism::id && registers_.read(ism::control_3) == ism::addresses_go_on;
  if (is_reset && configure() && is_configured()) {
    begin(now, tested_ ? Stage::warm_up : Stage::at_rest);
  } else if (now - since_ > longest_reset) {
    // What a line reads that nobody drives, or that is held down, is nobody.
    const std::uint8_t answer = id.value_or(0);
    restart(answer == ism::id || answer == 0x00 || answer == 0xFF ? Status::no_reading : Status::error);
  }
}

bool SecondImu::configure() {
  // First, or other settings may not be taken over; not asked for, because devices are reported that take it over and
  // read as if they had not.
  if (!registers_.write(ism::control_9, ism::configured)) {
    return false;
  }
  return std::ranges::all_of(
      settings, [this](const Setting& setting) { return registers_.write(setting.address, setting.value); });
}

bool SecondImu::is_configured() {
  return std::ranges::all_of(
      settings, [this](const Setting& setting) { return registers_.read(setting.address) == setting.value; });
}

void SecondImu::carry_on_self_test(Microseconds now) {
  if (now - since_ < stable_time) {
    return;
  }
  std::array<std::byte, burst_size> burst{};
  if (!registers_.read(ism::status, burst) || now - since_ > stable_time + longest_collection) {
    restart(Status::no_reading);
    return;
  }
  if ((std::to_integer<std::uint8_t>(burst[0]) & ism::gyro_ready) == 0) {
    return;
  }
  const Counts rate = little_endian_counts(std::span{burst}.subspan<2 + temperature_size, 6>());
  for (std::size_t i = 0; i < rate.size(); ++i) {
    sum_[i] += rate[i];
  }
  samples_ += 1;
  if (samples_ < samples_wanted) {
    return;
  }
  if (stage_ == Stage::at_rest) {
    at_rest_ = sum_;
    begin(now, Stage::actuated);
    if (!registers_.write(ism::self_test_control, ism::gyro_self_test)) {
      restart(Status::no_reading);
    }
    return;
  }
  // And with a reset all that the test has set is forgotten. One that has failed is tested again: a rocket that is
  // carried about fails.
  tested_ = passes(at_rest_, sum_);
  restart(tested_ ? Status::no_reading : Status::error);
}

void SecondImu::run(Microseconds now) {
  std::array<std::byte, burst_size> burst{};
  const bool answered = registers_.read(ism::status, burst);
  const auto id = registers_.read(ism::who_am_i);
  if (!answered || id != ism::id) {
    const std::uint8_t answer = id.value_or(0);
    miss(answer == 0x00 || answer == 0xFF || answer == ism::id ? Status::no_reading : Status::error);
    return;
  }
  misses_ = 0;
  if ((std::to_integer<std::uint8_t>(burst[0]) & ism::gyro_ready) != 0) {
    take(now, std::span{burst}.subspan(2 + temperature_size));
  }
  // Also what a device does that has reset itself: it sleeps.
  if (now - last_new_ > longest_without_sample) {
    restart(Status::no_reading);
  }
}

void SecondImu::miss(Status status) {
  sample_.status = status;
  misses_ += 1;
  // One answer may be spoilt by a disturbance; to reset the device for it would cost 110 ms.
  if (misses_ >= most_misses) {
    restart(status);
  }
}

void SecondImu::take(Microseconds now, std::span<const std::byte> burst) {
  const Counts rate = with_true_ends(little_endian_counts(burst.first<6>()));
  const Counts specific_force = little_endian_counts(burst.subspan<6, 6>());
  const bool same = rate == sample_.rate && specific_force == sample_.specific_force;
  repeats_ = same ? static_cast<std::uint8_t>(repeats_ + 1) : std::uint8_t{0};
  last_new_ = now;
  sample_ = {.time = now - age_when_found, .rate = rate, .specific_force = specific_force, .status = Status::ok};
  if (repeats_ >= most_repeats) {
    restart(Status::error);
  }
}

}  // namespace fantail::hal::stm32f4
