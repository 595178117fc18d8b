// SPDX-License-Identifier: MIT
// What the same rocket would have done with its canards at trim.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

using Changes = std::vector<input::Override>;

struct Pair {
  explicit Pair(const char* name, const Changes& changes = {})
      : scenario{input::load_scenario(name, changes)},
        flown{fly::fly_scenario(scenario)},
        free{fly::roll_without_control(scenario, flown)} {}

  sim::Scenario scenario;
  flight::Flight flown;
  std::vector<flight::FreeRollPoint> free;
};

TEST(WithoutControl, RollsAsTheFlightDidUntilControlStartsAndFartherAfterwards) {
  const Pair pair{"tasha3_launch2"};
  const double start_s = pair.flown.events.control_start_s.value();
  double largest_difference_rad = 0.0;
  for (const flight::Row& row : pair.flown.rows) {
    const auto free_rad = flight::free_roll_angle_rad(pair.free, row.time_s);
    if (free_rad && row.time_s <= start_s) {
      // Between two points 10 ms apart the line is off by an eighth of the acceleration's 1e-4 s2.
      ASSERT_NEAR(*free_rad, row.truth->roll_angle_rad, 1e-4) << row.time_s;
    } else if (free_rad) {
      largest_difference_rad = std::max(largest_difference_rad, std::abs(*free_rad - row.truth->roll_angle_rad));
    }
  }
  EXPECT_GT(largest_difference_rad, 2.0 * std::numbers::pi);  // the fins turn it by more than a turn
}

// Eq 1 where the rate is steady: alpha p = beta v u_d, the area on both sides. In the tunnel alpha is 19.4, beta 9.6,
// the wind 22 m/s, and fins and swirl come to -6.1 deg.
TEST(WithoutControl, InASteadyWindTurnsAsFastAsTheFinOffsetDrivesItAgainstTheDamping) {
  const Pair pair{"tunnel_steps", {{"run", "control_time_s", "20"}}};
  const double expected_deg_s = 9.6 / 19.4 * 22.0 * -6.1;
  EXPECT_NEAR(text::degrees(pair.free.back().true_roll_rate_rad_s), expected_deg_s, 0.05 * std::abs(expected_deg_s));
}

TEST(WithoutControl, IsTheFlightOfAPlanWhoseGainsAreZero) {
  const Pair pair{"tasha3_launch1"};
  const Changes zero{{"controller", "proportional_gain", "0"},
                     {"controller", "derivative_gain_s", "0"},
                     {"excitation", "form", "none"}};
  const flight::Flight slack = fly::fly_scenario(input::load_scenario("tasha3_launch1", zero));
  std::size_t compared = 0;
  for (const flight::Row& row : slack.rows) {
    const auto same = std::ranges::find(pair.free, row.time_s, &flight::FreeRollPoint::time_s);
    if (same != pair.free.end()) {
      ASSERT_EQ(same->true_roll_angle_rad, row.truth->roll_angle_rad) << row.time_s;
      ++compared;
    }
  }
  EXPECT_EQ(compared, pair.free.size());
}

TEST(WithoutControl, IsNotFlownWhereItSaysNothing) {
  EXPECT_TRUE(Pair{"gimbal"}.free.empty());
  EXPECT_TRUE(Pair{"tunnel_stability"}.free.empty());
  EXPECT_TRUE((Pair{"tasha3_launch1",
                    {{"controller", "proportional_gain", "0"},
                     {"controller", "derivative_gain_s", "0"},
                     {"excitation", "form", "none"}}}
                   .free.empty()))
      << "a law that never moves a canard by itself is without control already";
  EXPECT_TRUE((Pair{"tasha3_launch2", {{"launch_detection", "threshold_g", "10"}}}.free.empty()));  // never launched
}

TEST(WithoutControl, CanBeGivenUp) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const flight::Flight flown = fly::fly_scenario(scenario);
  EXPECT_THROW((void)fly::roll_without_control(scenario, flown, [](double) { throw 1; }), int);
}

}  // namespace
}  // namespace fantail::sil
