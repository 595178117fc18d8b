// SPDX-License-Identifier: MIT
// Nothing is green that the simulation of roll does not hold for: rockets that are not stable, and air that meets the
// rocket where its fins stall. What is expected is made from the numbers of the files and from the path that was flown.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "report/verdict.hpp"

namespace fantail::sil {
namespace {

sim::Scenario launch_with(const std::vector<std::string>& changes) {
  return input::load_scenario("tasha3_launch2", input::parse_overrides(changes));
}

report::Verdict verdict_on(const flight::Flight& flight) { return report::verdict(flight, report::figures(flight)); }

report::Verdict verdict_with(const std::vector<std::string>& changes) {
  return verdict_on(fly::fly_scenario(launch_with(changes)));
}

/// Of the flown path, from the beginning of control to its end, where the rocket was as fast as at first.
double largest_attack_deg(const flight::Flight& flight) {
  const auto speed_m_s = [](const flight::PathPoint& p) {
    return std::sqrt(p.north_m_s * p.north_m_s + p.east_m_s * p.east_m_s + p.up_m_s * p.up_m_s);
  };
  double first_m_s = 0.0;
  double largest_deg = 0.0;
  for (const flight::PathPoint& p : flight.path) {
    if (p.time_s < *flight.events.control_start_s ||
        p.time_s > flight.events.control_end_s.value_or(*flight.events.apogee_s)) {
      continue;
    }
    first_m_s = first_m_s > 0.0 ? first_m_s : speed_m_s(p);
    if (speed_m_s(p) >= first_m_s) {
      largest_deg = std::max(largest_deg, p.angle_of_attack_rad * 57.29577951308232);
    }
  }
  return largest_deg;
}

// The centre of gravity is at 0.9 m at lift-off and 0.875 after burn-out, a calibre 0.08 m.
TEST(OutsideModel, ARocketWithItsCentreOfPressureInFrontOfItsCentreOfGravityIsAmberInEveryMotion) {
  for (const double position_m : {0.5, 0.88, 0.899, 0.9}) {
    for (const char* const motion : {"straight", "six_dof"}) {
      const report::Verdict v = verdict_with(
          {fmt::format("airframe.centre_of_pressure_m={}", position_m), fmt::format("flight.motion={}", motion)});
      EXPECT_NE(v.outcome, report::Outcome::held) << position_m << " " << motion << ": " << v.text;
      EXPECT_TRUE(v.text.find("Outside the model: not stable, with a static margin down to ") != std::string::npos)
          << position_m << " " << motion << ": " << v.text;
    }
  }
  EXPECT_NE(verdict_with({"airframe.centre_of_pressure_m=0.5"}).text.find("down to -5.00 calibres"), std::string::npos);
  EXPECT_EQ(verdict_with({"airframe.centre_of_pressure_m=0.901"}).outcome, report::Outcome::held);
}

TEST(OutsideModel, ARocketThatIsStableAtLiftOffAloneIsAmber) {
  const report::Verdict v = verdict_with({"airframe.centre_of_gravity_after_burnout_m=1.06"});
  EXPECT_EQ(v.outcome, report::Outcome::outside_model);
  EXPECT_NE(v.text.find("down to -0.50 calibres"), std::string::npos) << v.text;
}

TEST(OutsideModel, WhereTheVehicleStatesNoCentresNothingIsSaidOfThem) {
  sim::Scenario unknown = launch_with({});
  unknown.vehicle.airframe.reset();
  const flight::Flight flight = fly::fly_scenario(unknown);
  EXPECT_EQ(verdict_on(flight).outcome, report::Outcome::held);
  EXPECT_FALSE(flight.extremes.static_margin_calibres);
}

// At 20 m/s, where control begins after a guide of 4 m, a wind of 3, 5 and 8 m/s comes at 8.5, 14 and 22 degrees.
TEST(OutsideModel, AirThatMeetsTheRocketAtMoreThanFifteenDegreesUnderControlIsAmber) {
  for (const std::vector<std::string>& changes : {std::vector<std::string>{"wind.speed_m_s=3"},
                                                  {"wind.speed_m_s=5"},
                                                  {"wind.speed_m_s=8", "run.tilt_limit_deg=90"},
                                                  {"wind.speed_m_s=8", "launch_guide.length_m=0.5"}}) {
    std::vector<std::string> six_dof = changes;
    six_dof.emplace_back("flight.motion=six_dof");
    const flight::Flight flight = fly::fly_scenario(launch_with(six_dof));
    const report::Verdict v = verdict_on(flight);
    const double attack_deg = largest_attack_deg(flight);
    EXPECT_EQ(v.outcome, attack_deg > 15.0 ? report::Outcome::outside_model : report::Outcome::held) << v.text;
    EXPECT_NEAR(*flight.extremes.angle_of_attack_rad * 57.29577951308232, attack_deg, 1e-6);
  }
  EXPECT_EQ(verdict_with({"wind.speed_m_s=5"}).outcome, report::Outcome::held) << "on a straight line";
  EXPECT_EQ(verdict_with({"wind.speed_m_s=8"}).outcome, report::Outcome::outside_model) << "on a straight line";
}

}  // namespace
}  // namespace fantail::sil
