// SPDX-License-Identifier: MIT
// Flights with a barometer, true and lying, beside the same flight without one.

#include <fmt/core.h>

#include "flight_log/integrity.hpp"
#include "flight_log/regenerate.hpp"
#include "input/scenario_file.hpp"
#include "sim/units.hpp"
#include "sim/world.hpp"
#include "test.hpp"

namespace fantail::sil::barometers {
namespace {

using core::BarometerState;
using core::PhaseReason;
using sim::Behaviour;
using sim::Device;

/// Kestrel, whose gate waits for 1 500 m. Its accelerometer's zero is off by 40 mg along the axis.
sim::Scenario kestrel(bool with_barometer, double height_m = 1'500.0) {
  sim::Scenario scenario = input::load_scenario("kestrel", {});
  scenario.plan.dormancy.until = core::DormantUntil::height;
  scenario.plan.dormancy.height_m = static_cast<float>(height_m);
  scenario.vehicle.imu.specific_force_bias_m_s2 = 0.04 * sim::gravity_m_s2;
  if (with_barometer) {
    scenario.vehicle.barometer.is_fitted = true;
    scenario.plan.sensors.barometer = core::BarometerUse::fused;
    scenario.plan.sensors.air_temperature_error_k = 3.0F;
  }
  return scenario;
}

struct Outcome {
  PhaseReason reason = PhaseReason::power_on;
  std::optional<double> launched_s;  ///< of the world's clock, as the others
  std::optional<double> control_s;   ///< began
  std::optional<double> control_m;   ///< in truth
  std::optional<double> ended_s;     ///< control
  double apogee_s = 0.0;             ///< in truth
  double error_at_apogee_m = 0.0;    ///< of the height that the law knows
  double speed_error_at_apogee_m_s = 0.0;
  std::vector<BarometerState> states;  ///< each once as it changes
  std::vector<std::byte> log;
};

Outcome fly(sim::Scenario scenario, const std::vector<sim::Fault>& faults = {}) {
  scenario.faults = faults;
  sim::World world{scenario, sim::World::large_flash};
  Outcome outcome;
  double highest_m = 0.0;
  while (!world.over()) {
    const core::TickRecord& record = world.tick();
    const double time_s = 1e-6 * static_cast<double>(record.time.count());
    const sim::Truth truth = world.truth();
    if (core::is_flight(record.phase)) {
      outcome.launched_s = outcome.launched_s.value_or(time_s);
    }
    if (record.phase == core::Phase::controlling && !outcome.control_s) {
      outcome.control_s = time_s;
      outcome.control_m = truth.height_m;
    } else if (record.phase == core::Phase::finished && !outcome.ended_s) {
      outcome.reason = record.reason;
      outcome.ended_s = time_s;
    }
    if (truth.height_m > highest_m) {
      highest_m = truth.height_m;
      outcome.apogee_s = time_s;
      outcome.error_at_apogee_m = static_cast<double>(record.motion.height_m) - truth.height_m;
      outcome.speed_error_at_apogee_m_s = static_cast<double>(record.motion.vertical_speed_m_s);
    }
    if (record.barometer_state && (outcome.states.empty() || outcome.states.back() != *record.barometer_state)) {
      outcome.states.push_back(*record.barometer_state);
    }
    world.advance();
  }
  outcome.log.assign(world.recorded().begin(), world.recorded().end());
  return outcome;
}

void print(const char* what, const Outcome& outcome) {
  fmt::print("{:32} control from {:.2f} s, {:.0f} m to {:.2f} s ({}), apogee {:.2f} s: {:+.1f} m, {:+.1f} m/s\n", what,
             outcome.control_s.value_or(-1), outcome.control_m.value_or(-1), outcome.ended_s.value_or(-1),
             name(outcome.reason), outcome.apogee_s, outcome.error_at_apogee_m, outcome.speed_error_at_apogee_m_s);
}

TEST(Barometer, TakesMostOfAnAccelerometersErrorAwayBeforeApogee) {
  const Outcome without = fly(kestrel(false));
  const Outcome with = fly(kestrel(true));
  print("without", without);
  print("with", with);
  EXPECT_TRUE(without.states.empty());
  EXPECT_EQ(with.states.front(), BarometerState::silent);
  EXPECT_NE(std::ranges::find(with.states, BarometerState::too_fast), with.states.end());
  EXPECT_NE(std::ranges::find(with.states, BarometerState::used), with.states.end());
  EXPECT_LT(std::abs(with.error_at_apogee_m), 0.5 * std::abs(without.error_at_apogee_m));
  EXPECT_LT(std::abs(with.speed_error_at_apogee_m_s), 0.5 * std::abs(without.speed_error_at_apogee_m_s));
}

// High up, where the rocket is slow and the accelerometer's error has grown: its apogee is 3 130 m.
TEST(Barometer, OpensAGateByHeightThatTheAccelerometerAloneDoesNotAndNotBelowIt) {
  const auto fly_up = [](bool with_barometer) {
    sim::Scenario scenario = kestrel(with_barometer, 2'900.0);
    scenario.plan.run.tilt_limit = core::Angle::from_degrees(90.0F);
    return fly(scenario);
  };
  const Outcome without = fly_up(false);
  const Outcome with = fly_up(true);
  print("without, 2900 m", without);
  print("with, 2900 m", with);
  EXPECT_FALSE(without.control_m);
  ASSERT_TRUE(with.control_m);
  EXPECT_GE(*with.control_m, 2'900.0);
}

TEST(Barometer, TheLogGivesTheFlightAgainByteForByte) {
  for (const auto& faults : {std::vector<sim::Fault>{},
                             {{.device = Device::barometer, .how = Behaviour::hangs, .from_s = 3.0, .until_s = 18.0}},
                             {{.device = Device::processor, .how = sim::Reset{}, .from_s = 15.0}}}) {
    for (const bool two_gyros : {false, true}) {
      sim::Scenario scenario = kestrel(true);
      scenario.plan.sensors.gyros = two_gyros ? core::GyroRule::two_agree : core::GyroRule::one;
      scenario.vehicle.second_imu_is_fitted = two_gyros;
      const Outcome flown = fly(scenario, faults);
      const flight_log::LogFile file = flight_log::parse_log(flown.log, "barometer");
      ASSERT_FALSE(file.flights.empty());
      for (const flight_log::Flight& flight : file.flights) {
        EXPECT_EQ(flight.unknown_records, 0U);
        const auto replay = flight_log::regenerate(flight, *flight.plan);
        EXPECT_TRUE(replay.complete_and_equal()) << flight_log::replay_text(flight, replay);
        const auto pressures =
            std::ranges::count_if(flight.ticks, [](const auto& tick) { return tick.tick.pressure.has_value(); });
        EXPECT_GT(pressures, 0);
        EXPECT_LT(10 * pressures, std::ssize(flight.ticks) + 100) << "one in ten ticks";
      }
    }
  }
}

TEST(Barometer, OneThatIsAskedForAndNotFittedArmsNobody) {
  sim::Scenario scenario = kestrel(true);
  scenario.vehicle.barometer.is_fitted = false;
  sim::World world{scenario};
  while (!world.over()) {
    EXPECT_EQ(world.tick().phase, core::Phase::safe);
    world.advance();
  }
  EXPECT_EQ(world.refusal_to_arm()->failure, protocol::SelfTestFailure::barometer_failed);
}

// As field reports have them, at the worst times.
TEST(Barometer, OneThatLiesNeitherBeginsALaunchNorEndsAFlightNorOpensAGateBelowItsHeight) {
  const Outcome healthy = fly(kestrel(true));
  for (const auto& [how, from_s, until_s, what] : {std::tuple{Behaviour::dead, -1e3, 200.0, "dead"},
                                                   {Behaviour::hangs, 3.0, 200.0, "hangs"},
                                                   {Behaviour::stuck, 1.0, 200.0, "equal samples"},
                                                   {Behaviour::blocked, -5.0, 200.0, "blocked port"},
                                                   {Behaviour::garbage, -5.0, 200.0, "garbage"},
                                                   {Behaviour::lit, 7.0, 9.0, "sunlight at the gate"},
                                                   {Behaviour::lit, 20.0, 23.0, "sunlight before apogee"}}) {
    const Outcome lied =
        fly(kestrel(true), {{.device = Device::barometer, .how = how, .from_s = from_s, .until_s = until_s}});
    print(what, lied);
    if (how == Behaviour::dead) {
      EXPECT_FALSE(lied.launched_s) << "the pad's self-test names it, and the rocket is not armed";
      continue;
    }
    EXPECT_EQ(lied.launched_s, healthy.launched_s) << what;
    EXPECT_EQ(lied.reason, healthy.reason) << what;
    ASSERT_TRUE(lied.ended_s && lied.control_m) << what;
    EXPECT_NEAR(*lied.ended_s, *healthy.ended_s, 1.5) << what;
    EXPECT_GE(*lied.control_m, 1'500.0) << what;
  }
}

// The second launch, slow enough for a barometer that stands still to agree with the accelerometer up to apogee.
TEST(Barometer, OneThatLiesNeverEndsControlBeforeTheAccelerometerAloneWould) {
  const auto launch2 = [](bool with_barometer) {
    sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
    scenario.vehicle.barometer.is_fitted = with_barometer;
    scenario.plan.sensors.barometer = with_barometer ? core::BarometerUse::fused : core::BarometerUse::none;
    return scenario;
  };
  const Outcome alone = fly(launch2(false));
  ASSERT_EQ(alone.reason, PhaseReason::apogee);
  for (const Behaviour how :
       {Behaviour::stuck, Behaviour::blocked, Behaviour::dead, Behaviour::hangs, Behaviour::garbage, Behaviour::lit}) {
    for (const double from_s : {-0.5, 3.0, 6.0, 8.0}) {
      const Outcome lied =
          fly(launch2(true), {{.device = Device::barometer, .how = how, .from_s = from_s, .until_s = 200.0}});
      EXPECT_EQ(lied.reason, PhaseReason::apogee);
      EXPECT_GE(*lied.ended_s, *alone.ended_s) << static_cast<int>(how) << " from " << from_s;
      EXPECT_LT(*lied.ended_s, *alone.ended_s + 1.0) << static_cast<int>(how) << " from " << from_s;
    }
  }
}

}  // namespace
}  // namespace fantail::sil::barometers
