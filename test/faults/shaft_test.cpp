// SPDX-License-Identifier: MIT
// Where the canards truly stand: flights made by hand in which every pulse is right, and flights of the simulator.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "faults/flown_cell.hpp"
#include "figures.hpp"
#include "input/scenario_file.hpp"
#include "made_flight.hpp"
#include "text/error.hpp"

namespace fantail::faults {
namespace {

using Change = std::function<void(Moment& moment)>;

std::string breach_where(const Change& truth, const Shafts& shafts = {}, double end_s = 3600.0) {
  return judged(made_flight({}, truth), {.begin_s = 3.0, .end_s = end_s, .shafts = shafts}).breach;
}

Change third_stands_at(double angle_deg, double from_s, double to_s = 3600.0) {
  return [=](Moment& moment) {
    if (moment.time_s >= from_s && moment.time_s < to_s) {
      moment.true_shaft_rad[2] = angle_deg * degree;
    }
  };
}

Shafts third(Shaft shaft) {
  Shafts shafts{};
  shafts[2] = shaft;
  return shafts;
}

TEST(FaultShaft, ThatStandsBeyondItsLimitIsRedThoughThePulseIsRight) {
  for (const double angle_deg : {9.2, -9.2, 25.0, std::nan("")}) {
    const std::string breach = breach_where(third_stands_at(angle_deg, 4.0, 4.001));
    EXPECT_TRUE(breach.find("canard 3") != std::string::npos && figures(breach).back() == "9.000") << breach;
    EXPECT_EQ(breach.find("trim"), std::string::npos) << breach;
  }
  EXPECT_EQ(breach_where(third_stands_at(-9.05, 4.0, 5.0)), "");
}

TEST(FaultShaft, ThatStandsOffTrimIsRedWhenItHadTheTimeToGetThere) {
  for (const double time_s : {-1.0, 0.35, 10.5}) {
    const std::string breach = breach_where(third_stands_at(0.2, time_s, time_s + 0.001));
    EXPECT_EQ(figures(breach), (std::vector<std::string>{"3", "0.200"})) << time_s << ": " << breach;
  }
  EXPECT_EQ(breach_where(third_stands_at(2.0, 9.0, 10.19)), "");
  EXPECT_NE(breach_where(third_stands_at(2.0, 9.0, 10.21)).find("in Finished"), std::string::npos);
  EXPECT_EQ(breach_where(third_stands_at(0.05, -5.0)), "");
}

TEST(FaultShaft, OfAFailedServoDoesWhatIsStatedOfItAndNoMore) {
  const auto stuck_at = [](double angle_deg) { return third_stands_at(angle_deg, 3.0); };
  EXPECT_EQ(breach_where(stuck_at(5.0), third(Shaft::stays_short)), "");
  EXPECT_NE(breach_where(stuck_at(9.2), third(Shaft::stays_short)), "");
  EXPECT_EQ(breach_where(stuck_at(25.0), third(Shaft::runs_away)), "");
  EXPECT_EQ(breach_where(stuck_at(3.9), third(Shaft::jolts)), "");
  EXPECT_NE(breach_where(stuck_at(4.2), third(Shaft::jolts)), "");
  EXPECT_EQ(breach_where(third_stands_at(12.9, 4.0, 5.0), third(Shaft::jolts)), "");
  EXPECT_EQ(breach_where(third_stands_at(2.0, 9.0, 10.9), third(Shaft::late)), "");
  EXPECT_NE(breach_where(stuck_at(5.0), third(Shaft::obeys)), "");
}

TEST(FaultShaft, IsHeldToItBeforeTheFaultAndWhenItIsOverAgain) {
  EXPECT_NE(breach_where(third_stands_at(25.0, 2.0, 2.1), third(Shaft::runs_away)), "");
  EXPECT_EQ(breach_where(third_stands_at(25.0, 3.0, 4.1), third(Shaft::runs_away), 4.0), "");
  EXPECT_NE(breach_where(third_stands_at(25.0, 3.0, 4.3), third(Shaft::runs_away), 4.0), "");
}

TEST(FaultShaft, OfTheOtherThreeIsHeldToAllOfItWhileOneFails) {
  EXPECT_NE(breach_where(
                [](Moment& moment) {
                  moment.true_shaft_rad[0] = moment.time_s > 4.0 ? 10.0 * degree : moment.true_shaft_rad[0];
                },
                third(Shaft::runs_away))
                .find("canard 1"),
            std::string::npos);
}

TEST(FaultShaft, InSafeAfterIgnitionGoesToTrimAndNotAwayFromIt) {
  const auto after_a_reset = [](double slope_deg_s) {
    const Change safe = [](Moment& moment) {
      if (moment.time_s > 5.0) {
        moment.phase = core::Phase::safe;
        moment.ticked = moment.time_s > 5.06;
        moment.commanded_rad.fill(std::nullopt);
      }
    };
    return judged(
        made_flight(safe,
                    [slope_deg_s](Moment& moment) {
                      if (moment.time_s > 5.0) {
                        moment.true_shaft_rad.fill(std::max(0.0, 2.0 + slope_deg_s * (moment.time_s - 5.0)) * degree);
                      }
                    }),
        at_three);
  };
  EXPECT_EQ(after_a_reset(-30.0).breach, "");
  EXPECT_EQ(after_a_reset(0.0).breach, "");
  EXPECT_NE(after_a_reset(1.0).breach.find("Safe"), std::string::npos);
}

// Without a pulse there is no command off trim to be found, and the canards stand where friction holds them.
TEST(FaultShaft, ThatStandsOffTrimWithoutAPulseIsNotOver) {
  const auto ends = [](double stands_until_s) {
    const Change without_pulses = [](Moment& moment) {
      if (moment.time_s > 3.1) {
        moment.phase = core::Phase::safe;
        moment.commanded_rad.fill(std::nullopt);
      }
    };
    return judged(
        made_flight(without_pulses,
                    [=](Moment& moment) {
                      moment.true_shaft_rad.fill(
                          moment.time_s > control_begin_s && moment.time_s < stands_until_s ? 2.0 * degree : 0.0);
                    }),
        at_three);
  };
  EXPECT_EQ(ends(3.45).outcome(any_of(Outcome::over)), Outcome::over);
  EXPECT_NEAR(ends(3.45).stands_after_s, 0.45, 0.0015);
  EXPECT_EQ(ends(3.55).outcome(any_of(Outcome::over)), std::nullopt);
  EXPECT_EQ(ends(3.55).breach, "");
}

TEST(FaultShaft, HasTheErrorsOfTheServosAndOfThePlanAndOfABrokenCanardNothingIsAsked) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const ShaftLimits usual = shaft_limits(scenario);
  EXPECT_NEAR(usual.off_rad[0], 0.06 * degree, 0.02 * degree);
  EXPECT_NEAR(usual.travel_s, 0.18, 0.03);
  scenario.vehicle.servo.pulse_centre_us += 10.0;  // a degree
  EXPECT_NEAR(shaft_limits(scenario).off_rad[0] - usual.off_rad[0], 1.0 * degree, 1e-6);
  scenario.faults.push_back({.device = sim::Device::servo, .canard = 2, .how = sim::GearFault{}, .from_s = 1.0});
  EXPECT_TRUE(std::isinf(shaft_limits(scenario).off_rad[2]));
  EXPECT_TRUE(std::isfinite(shaft_limits(scenario).off_rad[1]));
}

// The same pulses, and a servo at its stop: with what is stated of it the cell is what it is without, and red where
// nothing is stated.
TEST(FaultShaft, AtItsStopIsSeenInAFlightOfTheSimulator) {
  const Twins twins = fly_twins(input::load_scenario("tasha3_launch2", {}), 1);
  Cell cell = cell_of("servo/hardover/controlling");
  const Grid::Run run{.seed = 0, .begin_ms = 3000};
  EXPECT_EQ(fly_run(twins, cell, run, 0).breach, "");
  FaultRow nothing_stated = *cell.row;
  nothing_stated.shaft = Shaft::obeys;
  cell.row = &nothing_stated;
  EXPECT_NE(fly_run(twins, cell, run, 0).breach.find("canard 1"), std::string::npos);
}

// Servos so weak that the air turns them: without any fault the canards go where no pulse asks them to.
TEST(FaultTwin, ThatBreaksARuleItselfIsRefused) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.vehicle.servo.torque_n_m = 0.001;
  scenario.vehicle.canard_air.hinge_moment_m3 = -1e-5;
  try {
    (void)fly_twins(scenario, 1);
    FAIL() << "it was taken";
  } catch (const text::Error& error) {
    EXPECT_NE(std::string{error.what()}.find("none of the faults, the flight breaks"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace fantail::faults
