// SPDX-License-Identifier: MIT
// A second IMU in the second launch: what a fault of one costs, beside the same fault of the only one.

#include <fmt/core.h>

#include "core/flight_plan_fields.hpp"
#include "flight_log/integrity.hpp"
#include "flight_log/regenerate.hpp"
#include "input/scenario_file.hpp"
#include "sim/world.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

using core::CommandStatus;
using core::GyroVote;
using core::PhaseReason;
using sim::Behaviour;
using sim::Device;
using text::degrees;

constexpr double fault_s = 3.0;  // after ignition: in the middle of control

sim::Scenario launch2(bool two_gyros) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  if (two_gyros) {
    scenario.plan.sensors.gyros = core::GyroRule::two_agree;
    scenario.vehicle.second_imu_is_fitted = true;
    // Not the same gyro twice: its own bias, scale, noise and seat.
    scenario.vehicle.second_imu.rate_bias_rad_s = text::radians(0.8);
    scenario.vehicle.second_imu.misalignment_rad = text::radians(0.5);
    scenario.vehicle.second_imu.delay_s = 0.001;
    scenario.vehicle.second_imu.full_scale_rad_s = text::radians(4000.0);
    scenario.vehicle.second_imu_feels.rate_scale_error = 0.005;
  }
  return scenario;
}

sim::Fault fault(Device imu, sim::How how, double until_s) {
  return {.device = imu, .how = how, .from_s = fault_s, .until_s = until_s};
}
sim::Fault offset(Device imu, double offset_deg_s, double until_s) {
  return fault(imu, sim::RateOffset{text::radians(offset_deg_s)}, until_s);
}

struct Outcome {
  PhaseReason reason = PhaseReason::power_on;
  double control_ended_s = 0.0;  ///< after ignition
  double angle_error_deg = 0.0;  ///< largest, of the roll angle that the avionics believes, under control
  double at_trim_s = 0.0;        ///< under control, because no rate was believed
  double rolled_deg = 0.0;       ///< how far the rocket is from its reference as control ends
  std::vector<GyroVote> votes;   ///< under control, each once as it changes
  std::vector<std::byte> log;
};

Outcome fly(sim::Scenario scenario, const std::vector<sim::Fault>& faults) {
  scenario.faults = faults;
  sim::World world{scenario, sim::World::large_flash};
  Outcome outcome;
  while (!world.over()) {
    const core::TickRecord& record = world.tick();
    const double truth_rad = world.truth().roll_angle_rad;
    const double error_deg = std::abs(degrees(static_cast<double>(record.motion.roll_angle.radians()) - truth_rad));
    if (record.phase == core::Phase::controlling) {
      outcome.control_ended_s = 1e-6 * static_cast<double>(record.time.count()) - scenario.pad_time_s;
      outcome.angle_error_deg = std::max(outcome.angle_error_deg, error_deg);
      outcome.at_trim_s += record.command_status == CommandStatus::gyro_lost ? 0.001 : 0.0;
      outcome.rolled_deg = std::abs(degrees(truth_rad - static_cast<double>(record.reference.radians())));
      if (record.gyro_vote && (outcome.votes.empty() || outcome.votes.back() != *record.gyro_vote)) {
        outcome.votes.push_back(*record.gyro_vote);
      }
    } else if (record.phase == core::Phase::finished) {
      outcome.reason = record.reason;
    }
    world.advance();
  }
  outcome.log.assign(world.recorded().begin(), world.recorded().end());
  return outcome;
}

void print(const char* what, const Outcome& outcome) {
  fmt::print(
      "{:44} control until {:6.3f} s ({}), at trim {:5.3f} s, angle error {:5.2f} deg, {:6.1f} deg off at its end\n",
      what, outcome.control_ended_s, name(outcome.reason), outcome.at_trim_s, outcome.angle_error_deg,
      outcome.rolled_deg);
}

TEST(TwoGyros, ThatAgreeFlyAsOneDoes) {
  const Outcome one = fly(launch2(false), {});
  const Outcome two = fly(launch2(true), {});
  print("one, no fault", one);
  print("two, no fault", two);
  EXPECT_EQ(two.reason, PhaseReason::apogee);
  EXPECT_EQ(two.votes, std::vector{GyroVote::both});
  EXPECT_EQ(two.angle_error_deg, one.angle_error_deg) << "the first flies, and no second disturbs it";
}

TEST(TwoGyros, WhereTheFirstFailsControlGoesOnByTheSecondWithoutACoast) {
  for (const auto& [how, what] : {std::pair{Behaviour::hangs, "first hangs for good"},
                                  std::pair{Behaviour::gyro_frozen, "first frozen for good"}}) {
    const Outcome one = fly(launch2(false), {fault(Device::imu, how, 40.0)});
    const Outcome two = fly(launch2(true), {fault(Device::imu, how, 40.0)});
    print((std::string{"one, "} + what).c_str(), one);
    print((std::string{"two, "} + what).c_str(), two);
    EXPECT_EQ(two.reason, PhaseReason::apogee) << what;
    EXPECT_EQ(two.at_trim_s, 0.0) << what;
    EXPECT_EQ(two.votes.back(), GyroVote::second) << what;
    EXPECT_LT(two.angle_error_deg, 3.0) << what;
    EXPECT_GT(one.rolled_deg, two.rolled_deg) << what;
  }
}

TEST(TwoGyros, WhereTheSecondFailsNothingIsFelt) {
  const Outcome whole = fly(launch2(true), {});
  for (const Behaviour how : {Behaviour::hangs, Behaviour::gyro_frozen}) {
    const Outcome failed = fly(launch2(true), {fault(Device::second_imu, how, 40.0)});
    EXPECT_EQ(failed.votes.back(), GyroVote::first);
    EXPECT_EQ(failed.angle_error_deg, whole.angle_error_deg);
    EXPECT_EQ(failed.at_trim_s, 0.0);
  }
}

// Nobody can say which one is wrong: canards at trim, and control again where they agree within the longest gap.
TEST(TwoGyros, ThatDisagreeAreWaitedForAsASilentOneIs) {
  const Outcome again = fly(launch2(true), {offset(Device::imu, 100.0, fault_s + 0.1)});
  print("two, first 100 deg/s off for 0.1 s", again);
  EXPECT_EQ(again.reason, PhaseReason::apogee);
  // 20 ms until it is one; 20 ms, and the fifth sample, until it is none.
  EXPECT_NEAR(again.at_trim_s, 0.1 - 0.02 + 0.024, 0.002);
  EXPECT_LT(again.angle_error_deg, 10.0);

  const Outcome ended = fly(launch2(true), {offset(Device::second_imu, -100.0, 40.0)});
  print("two, second 100 deg/s off for good", ended);
  EXPECT_EQ(ended.reason, PhaseReason::gyro_failed);
  EXPECT_NEAR(ended.control_ended_s, fault_s + 0.02 + 0.25, 0.003);
  EXPECT_EQ(ended.votes.back(), GyroVote::disagree);

  const Outcome one = fly(launch2(false), {offset(Device::imu, 100.0, 40.0)});
  print("one, 100 deg/s off for good", one);
  EXPECT_GT(one.rolled_deg, 360.0) << "steered by a wrong rate to apogee, it spins";
}

// What a resumed flight law remembers of the two comes with it.
TEST(TwoGyros, AFrozenOneStaysAsideThroughAResetInFlight) {
  const Outcome outcome = fly(launch2(true), {fault(Device::imu, Behaviour::gyro_frozen, 40.0),
                                              {.device = Device::processor, .how = sim::Reset{}, .from_s = 5.0}});
  print("two, first frozen, reset at 5 s", outcome);
  EXPECT_EQ(outcome.reason, PhaseReason::apogee);
  EXPECT_EQ(outcome.votes, (std::vector{GyroVote::both, GyroVote::second}));
  EXPECT_EQ(outcome.at_trim_s, 0.0);
  EXPECT_LT(outcome.angle_error_deg, 3.0);
}

TEST(TwoGyros, OneTooManyThatIsNotFittedArmsNobody) {
  sim::Scenario scenario = launch2(true);
  scenario.vehicle.second_imu_is_fitted = false;
  sim::World world{scenario};
  while (!world.over()) {
    EXPECT_EQ(world.tick().phase, core::Phase::safe);
    world.advance();
  }
  EXPECT_EQ(world.refusal_to_arm()->failure, protocol::SelfTestFailure::second_gyro_failed);
}

TEST(TwoGyros, TheLogGivesTheFlightAgainByteForByte) {
  for (const auto& faults : {std::vector<sim::Fault>{},
                             {fault(Device::imu, Behaviour::hangs, 3.5)},
                             {offset(Device::imu, 100.0, fault_s + 0.1)},
                             {fault(Device::second_imu, Behaviour::gyro_frozen, 5.0)}}) {
    const Outcome flown = fly(launch2(true), faults);
    const flight_log::LogFile file = flight_log::parse_log(flown.log, "two gyros");
    ASSERT_EQ(file.flights.size(), 1U);
    const flight_log::Flight& flight = file.flights.front();
    EXPECT_TRUE(flight_log::intact(file));
    EXPECT_EQ(flight.format_version, 2);
    const auto replay = flight_log::regenerate(flight, *flight.plan);
    EXPECT_TRUE(replay.complete_and_equal()) << flight_log::replay_text(flight, replay);

    core::FlightPlan of_one = *flight.plan;
    of_one.sensors.gyros = core::GyroRule::one;
    EXPECT_NE(flight_log::regenerate(flight, of_one).obstacle.find("sensors.gyros"), std::string::npos);
  }
}

}  // namespace
}  // namespace fantail::sil
