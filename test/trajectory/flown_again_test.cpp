// SPDX-License-Identifier: MIT
// A flight of our own, exported as the other programs do, and flown again on what they would tell.
#include <gtest/gtest.h>

#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "report/figures.hpp"
#include "text/degrees.hpp"
#include "trajectory/flown_export.hpp"
#include "trajectory/trajectory.hpp"

namespace fantail::test {
namespace {

sim::Scenario scenario(const std::vector<std::string>& changes) {
  return input::load_scenario("tasha3_launch2", input::parse_overrides(changes));
}

flight::Flight fly_on(sim::Scenario scenario, const std::string& text) {
  trajectory::Trajectory trajectory = trajectory::parse_trajectory(text, "other.csv", scenario);
  scenario.path = std::move(trajectory.path);
  return fly::fly_scenario(scenario);
}

/// Up to apogee, by the time after ignition: how lift-off is seen may differ by a row of the table.
void expect_same_roll(const flight::Flight& own, const flight::Flight& again) {
  const double apogee_s = own.events.apogee_s.value();
  EXPECT_NEAR(again.events.apogee_s.value(), apogee_s, 0.02);
  EXPECT_NEAR(report::figures(again).apogee_m.value(), report::figures(own).apogee_m.value(), 0.01);
  EXPECT_NEAR(again.events.burnout_s.value(), own.events.burnout_s.value(), 0.1);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < own.rows.size() && i < again.rows.size() && own.rows[i].time_s < apogee_s; ++i) {
    const flight::Truth& a = own.rows[i].truth.value();
    const flight::Truth& b = again.rows[i].truth.value();
    ASSERT_NEAR(text::degrees(a.roll_angle_rad), text::degrees(b.roll_angle_rad), 0.1) << own.rows[i].time_s;
    ASSERT_NEAR(a.height_m, b.height_m, 0.01) << own.rows[i].time_s;
    ++compared;
  }
  EXPECT_GT(compared, 10000U);
}

TEST(FlownAgain, AStraightFlightRollsAsItDid) {
  const sim::Scenario own = scenario({});
  const auto flown = instants(own, 10);
  const flight::Flight flight = fly::fly_scenario(own);
  expect_same_roll(flight, fly_on(own, as_rocketpy(flown)));
  expect_same_roll(flight, fly_on(own, as_openrocket(flown)));
}

TEST(FlownAgain, AFlightInSixDegreesOfFreedomFromALeaningGuideRollsAsItDid) {
  const sim::Scenario own = scenario({"flight.motion=six_dof", "launch_guide.tilt_deg=5"});
  const auto flown = instants(own, 10);
  const flight::Flight flight = fly::fly_scenario(own);
  expect_same_roll(flight, fly_on(own, as_rocketpy(flown)));
  expect_same_roll(flight, fly_on(own, as_openrocket(flown)));
}

// A motion along the guide shows no tilt, so nobody may take it for one that stays below a limit.
TEST(FlownAgain, ATrajectoryHasATrueTiltUnlessItGoesAlongTheGuideThroughout) {
  const auto has_tilt = [](const std::vector<std::string>& changes) {
    const sim::Scenario own = scenario(changes);
    return fly_on(own, as_rocketpy(instants(own, 10))).rows.back().truth->tilt_from_guide_rad.has_value();
  };
  EXPECT_FALSE(has_tilt({}));
  EXPECT_TRUE(has_tilt({"flight.motion=six_dof", "launch_guide.tilt_deg=5"}));
}

TEST(FlownAgain, AFlightInWindRollsAsItDid) {
  const sim::Scenario own = scenario({"flight.motion=six_dof", "wind.speed_m_s=5", "wind.from_deg=270",
                                      "airframe.roll_inertia_after_burnout_kg_m2=0.0035"});
  const flight::Flight flight = fly::fly_scenario(own);
  expect_same_roll(flight, fly_on(own, as_rocketpy_in_wind(instants(own, 10))));
}

TEST(FlownAirframe, HasTheRollInertiaOverTimeWhereTheFlightFollowsThePropellant) {
  const std::vector<std::string> empties{"airframe.roll_inertia_after_burnout_kg_m2=0.0035"};
  EXPECT_TRUE(fly::fly_scenario(scenario(empties)).airframe->roll_inertia_course.empty());
  const flight::Flight flight = fly::fly_scenario(scenario({"flight.motion=six_dof", empties.front()}));
  const auto& course = flight.airframe->roll_inertia_course;
  ASSERT_FALSE(course.empty());
  EXPECT_EQ(course.begin()->second, 0.00393);
  EXPECT_EQ(course.rbegin()->second, 0.0035);
  EXPECT_NEAR(course.rbegin()->first, flight.events.burnout_s.value(), 0.1);
}

TEST(FlownAgain, TheEstimatedTiltIsThatOfThePath) {
  const sim::Scenario own = scenario({"flight.motion=six_dof", "launch_guide.tilt_deg=10"});
  const flight::Flight flight = fly::fly_scenario(own);
  const flight::Flight again = fly_on(own, as_openrocket(instants(own, 10)));
  // The tilt limit ends control where the estimator sees it pass.
  ASSERT_EQ(flight.phase_changes.back().reason, core::PhaseReason::tilted_too_far);
  EXPECT_EQ(again.phase_changes.back().reason, core::PhaseReason::tilted_too_far);
  EXPECT_NEAR(again.events.control_end_s.value(), flight.events.control_end_s.value(), 0.05);
}

}  // namespace
}  // namespace fantail::test
