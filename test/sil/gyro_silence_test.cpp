// SPDX-License-Identifier: MIT
// How long may a gyro be silent in flight? The figures of docs/devices.md, and the claim behind them: to wait for it,
// with the canards at trim, is never worse than to end control.
#include <cstdlib>

#include <fmt/core.h>

#include "core/flight_plan_fields.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

using text::degrees;

struct Silence {
  double from_s;  ///< after ignition, as faults count
  double length_s;
};

struct Outcome {
  double angle_error_deg = 0.0;  ///< of the roll angle that the avionics believes, as control ends
  double away_deg = 0.0;         ///< how far the rocket rolled from where it stood while nobody controlled it
  double at_apogee_deg = 0.0;    ///< distance from the settle point at apogee
  bool to_apogee = false;        ///< control lasted until then
};

Outcome fly(const sim::Scenario& usual, const Silence& silence, double longest_gap_s) {
  sim::Scenario scenario = usual;
  scenario.plan.motion.longest_gyro_gap = core::from_seconds(static_cast<float>(longest_gap_s));
  scenario.faults = {{.device = sim::Device::imu,
                      .how = sim::Behaviour::hangs,
                      .from_s = silence.from_s,
                      .until_s = silence.from_s + silence.length_s}};
  const flight::Flight flight = fly::fly_scenario(scenario);
  Outcome outcome;
  double before_rad = 0.0;
  const flight::Row* last = nullptr;
  for (const flight::Row& row : flight.rows) {
    if (row.time_s > *flight.events.apogee_s) {
      break;
    }
    if (row.phase != core::Phase::controlling) {
      continue;
    }
    if (row.time_s < silence.from_s) {
      before_rad = row.truth->roll_angle_rad;
    } else if (row.time_s < silence.from_s + silence.length_s) {
      outcome.away_deg = std::max(outcome.away_deg, std::abs(degrees(row.truth->roll_angle_rad - before_rad)));
    }
    last = &row;
  }
  if (last == nullptr) {
    return outcome;
  }
  outcome.angle_error_deg = std::abs(degrees(last->roll_angle_rad - last->truth->roll_angle_rad));
  outcome.to_apogee = flight.phase_changes.back().reason == core::PhaseReason::apogee;
  const auto apogee =
      std::ranges::find_if(flight.rows, [&](const flight::Row& r) { return r.time_s >= *flight.events.apogee_s; });
  outcome.at_apogee_deg =
      std::abs(degrees(apogee->truth->roll_angle_rad - *flight::settle_point_rad(*last, flight.plan)));
  return outcome;
}

void take_worst(Outcome& worst, const Outcome& one) {
  worst.angle_error_deg = std::max(worst.angle_error_deg, one.angle_error_deg);
  worst.away_deg = std::max(worst.away_deg, one.away_deg);
  worst.at_apogee_deg = std::max(worst.at_apogee_deg, one.at_apogee_deg);
  worst.to_apogee = worst.to_apogee && one.to_apogee;
}

sim::Scenario launch2_with_offset(double offset_deg) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.disturbance = {{.time_s = 0.0, .angle_rad = text::radians(offset_deg)}};
  return scenario;
}

// All of the table with FANTAIL_ALL_SILENCES, which takes a minute.
TEST(GyroSilence, ToWaitForTheGyroWithTheCanardsAtTrimIsBetterThanToEndControl) {
  const bool all =
      std::getenv("FANTAIL_ALL_SILENCES") != nullptr;  // NOLINT(concurrency-mt-unsafe): there is one thread
  const double longest_s = core::seconds(core::default_plan().motion.longest_gyro_gap);
  const std::vector<double> lengths_s =
      all ? std::vector{0.007, 0.02, 0.05, 0.1, 0.15, 0.2, 0.24, 0.3, 0.5, 0.8} : std::vector{0.007, 0.1, 0.24};
  fmt::print(
      "worst over the start of the silence\nu_d deg  silent ms  angle error  rolled away  at apogee: waited  ended\n");
  for (const double offset_deg : {-4.9, -8.0}) {
    const sim::Scenario scenario = launch2_with_offset(offset_deg);
    for (const double length_s : lengths_s) {
      Outcome waited{.to_apogee = true};
      Outcome ended{.to_apogee = true};
      for (double from_s = 0.2; from_s < 9.3; from_s += all ? 0.35 : 1.75) {
        take_worst(waited, fly(scenario, {from_s, length_s}, 1.0));
        take_worst(ended, fly(scenario, {from_s, length_s}, 0.0));
      }
      fmt::print("{:7.1f} {:10.0f} {:12.1f} {:12.1f} {:18.1f} {:6.1f}\n", offset_deg, 1e3 * length_s,
                 waited.angle_error_deg, waited.away_deg, waited.at_apogee_deg, ended.at_apogee_deg);
      EXPECT_TRUE(waited.to_apogee);
      EXPECT_LT(waited.at_apogee_deg, ended.at_apogee_deg);
      if (length_s < longest_s) {
        EXPECT_LT(waited.angle_error_deg, 10.0) << "the default of longest_gyro_gap_s is chosen for this";
      }
    }
  }
}

TEST(GyroSilence, LongerThanThePlansLongestGapEndsControl) {
  const sim::Scenario scenario = launch2_with_offset(-4.9);
  EXPECT_TRUE(fly(scenario, {3.0, 0.24}, 0.25).to_apogee);
  EXPECT_FALSE(fly(scenario, {3.0, 0.26}, 0.25).to_apogee);
}

}  // namespace
}  // namespace fantail::sil
