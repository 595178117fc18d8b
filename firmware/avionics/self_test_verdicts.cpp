// SPDX-License-Identifier: MIT
#include <algorithm>

#include "avionics/self_test.hpp"
#include "core/finite.hpp"

// What the self-test says of sensors and flash.
namespace fantail::avionics {

using core::Microseconds;
using protocol::SelfTestFailure;

namespace {

constexpr Microseconds gyro_patience{100'000};  // for a spike, or a sample that came late
constexpr float one_g_tolerance_m_s2 = 0.1F * core::standard_gravity_m_s2;

// On every pad from below the sea to 4 500 m. An MS5607 sold as an MS5611 reads half the pressure, which is outside.
constexpr float least_pad_pressure_pa = 56'000.0F;
constexpr float largest_pad_pressure_pa = 112'000.0F;

// A record of a tick is at most 80 bytes, and with all that stands between the ticks a flight has less than 80 a tick.
constexpr std::int64_t record_bytes_per_s = 80'000;

}  // namespace

std::uint32_t SelfTest::record_bytes(const core::FlightPlan& plan) {
  const std::int64_t recorded_s = (plan.run.control_time + recorded_after_control).count() / 1'000'000 + 1;
  return static_cast<std::uint32_t>(record_bytes_per_s * recorded_s);
}

// Two that do not both fly any more. The one that failed has its name.
std::optional<SelfTestFailure> SelfTest::judge_gyros(const core::TickRecord& record) {
  using core::GyroVote;
  if (!record.gyro_vote || *record.gyro_vote == GyroVote::both) {
    gyros_agreed_ = record.time;
  }
  if (record.time - gyros_agreed_ <= gyro_patience) {
    return std::nullopt;
  }
  switch (*record.gyro_vote) {
    case GyroVote::first: return SelfTestFailure::second_gyro_failed;
    case GyroVote::disagree: return SelfTestFailure::gyros_disagree;
    default: return SelfTestFailure::gyro_failed;
  }
}

std::optional<SelfTestFailure> SelfTest::judge_averages() const {
  const auto failure = judge_sensors();
  return failure ? failure : judge_gyro_zeros();
}

// Two gyros of different makers that read the same turn do not disagree: it may be the rocket that turns.
std::optional<SelfTestFailure> SelfTest::judge_gyro_zeros() const {
  const float largest_rad_s = core::largest_gyro_bias_rad_s(plan_->motion);
  if (gyro_zeros_[0].is_beyond(largest_rad_s)) {
    return SelfTestFailure::gyro_turns;
  }
  return gyro_zeros_[1].is_beyond(largest_rad_s) ? std::optional{SelfTestFailure::second_gyro_turns} : std::nullopt;
}

bool SelfTest::barometer_fails(const core::TickRecord& record) const {
  const bool is_of_a_pad = pressure_pa_ >= least_pad_pressure_pa && pressure_pa_ < largest_pad_pressure_pa;
  return record.barometer_state && (*record.barometer_state == core::BarometerState::silent || !is_of_a_pad);
}

// Meets PLN-2.
std::optional<SelfTestFailure> SelfTest::judge_flash(const FlashFacts& flash) const {
  if (flash.failed) {
    return SelfTestFailure::flash_failed;
  }
  if (flash.plan == protocol::PlanSource::stored_is_broken) {
    return SelfTestFailure::no_valid_plan;
  }
  if (flash.plan == protocol::PlanSource::stored_is_newer) {
    return SelfTestFailure::newer_plan;
  }
  return *flash.free_bytes < std::min(record_bytes(*plan_), flash.region_bytes)
             ? std::optional{SelfTestFailure::flash_too_full}
             : std::nullopt;
}

std::optional<SelfTestFailure> SelfTest::judge_sensors() const {
  for (std::size_t i = 0; i < needed_accelerometers(); ++i) {
    if (averages_[i].samples < 1.0F) {
      return std::nullopt;  // the rocket has just moved, so nothing is known yet
    }
    const float off_m_s2 = averages_[i].mean_m_s2() - core::standard_gravity_m_s2;
    if (off_m_s2 > one_g_tolerance_m_s2 || off_m_s2 < -one_g_tolerance_m_s2) {
      return SelfTestFailure::specific_force_not_one_g;
    }
  }
  if (needed_accelerometers() == 2) {
    const float apart_m_s2 = averages_[0].mean_m_s2() - averages_[1].mean_m_s2();
    if (!core::is_within(apart_m_s2, plan_->launch_detection.disagreement_m_s2)) {
      return SelfTestFailure::accelerometers_disagree;
    }
  }
  return std::nullopt;
}

}  // namespace fantail::avionics
