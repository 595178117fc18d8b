// SPDX-License-Identifier: MIT
// What the page of a held rocket shows of all three axes.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

using flight::TurnPoint;

flight::Flight fly(const char* scenario) { return fly::fly_scenario(input::load_scenario(scenario, {})); }

double largest_deg(const flight::Flight& flight, double TurnPoint::* member) {
  double largest_rad = 0.0;
  for (const TurnPoint& point : flight.turning) {
    largest_rad = std::max(largest_rad, std::abs(point.*member));
  }
  return text::degrees(largest_rad);
}

// gimbal.toml: 20 degrees in roll and 45 in pitch and yaw, each within 2 s; the fastest moment is twice the mean.
TEST(Turning, OnTheGimbalIsWhatTheHandsDidAndWhatTheGyroMadeOfIt) {
  const flight::Flight flight = fly("gimbal");
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::true_roll_rate_rad_s), 20.0, 0.1);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::true_pitch_rate_rad_s), 45.0, 0.1);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::true_yaw_rate_rad_s), 45.0, 0.1);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::true_tilt_rad), 45.0, 0.1);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::gyro_roll_rate_rad_s), 20.0, 2.0);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::gyro_pitch_rate_rad_s), 45.0, 2.0);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::gyro_yaw_rate_rad_s), 45.0, 2.0);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::tilt_rad), 45.0, 1.0);
  // The second turn in pitch brings it upright again.
  const auto upright = std::ranges::find_if(flight.turning, [](const TurnPoint& p) { return p.time_s >= 17.0; });
  EXPECT_NEAR(text::degrees(upright->true_tilt_rad), 0.0, 0.01);
}

TEST(Turning, OnPinsIsTheSwing) {
  const flight::Flight flight = fly("tunnel_stability");
  EXPECT_EQ(largest_deg(flight, &TurnPoint::true_roll_rate_rad_s), 0.0);
  EXPECT_EQ(largest_deg(flight, &TurnPoint::true_yaw_rate_rad_s), 0.0);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::true_pitch_rate_rad_s), 3.0, 0.3);  // the hardest push
}

TEST(Turning, IsNotShownOfAFlight) { EXPECT_TRUE(fly("tasha3_launch2").turning.empty()); }

}  // namespace
}  // namespace fantail::sil
