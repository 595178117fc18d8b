// SPDX-License-Identifier: MIT
// A gyro that stands wrong in a rocket that is turned right reads what a right one reads in a rocket that is turned
// wrong: so the hands make the errors.
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "bench/axes.hpp"
#include "sil/bench_at_world.hpp"

namespace fantail::sil {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

bench::AxesResult result_of(const std::function<void(sim::Scenario&)>& change) {
  sim::Scenario scenario = input::load_scenario("bench_axes", {});
  change(scenario);
  BenchAtWorld place{std::move(scenario)};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  return bench::judge_axes(bench::watch_turns(place, link, [](const bench::AskedTurn&) {}));
}

bench::AxesResult result_of_turns(const std::function<void(sim::Vector3&)>& change) {
  return result_of([&change](sim::Scenario& scenario) {
    for (sim::HandTurn& turn : scenario.hand_turns) {
      change(turn.angle_rad);
    }
  });
}

TEST(BenchAxes, ARightGyroPasses) {
  const bench::AxesResult result = result_of([](sim::Scenario&) {});
  EXPECT_TRUE(result.right) << bench::axes_text(result);
  EXPECT_NEAR(result.seen_rad[0], 360.0 * degree, 1.0 * degree);
  EXPECT_NEAR(result.seen_rad[1], 0.0, 0.5 * degree);
  EXPECT_NEAR(result.seen_rad[2], 0.0, 0.5 * degree);
}

TEST(BenchAxes, AReversedRollIsNamed) {
  const bench::AxesResult result = result_of_turns([](sim::Vector3& turn) { turn.x = -turn.x; });
  EXPECT_FALSE(result.right);
  EXPECT_NE(bench::axes_text(result).find("The roll is reversed"), std::string::npos) << bench::axes_text(result);
}

TEST(BenchAxes, SwappedAxesAreNamedWhicheverSideTheNoseIsTippedTo) {
  const bench::AxesResult pitch = result_of_turns([](sim::Vector3& turn) { std::swap(turn.x, turn.y); });
  EXPECT_NE(bench::axes_text(pitch).find("sees the pitch: it lies across the rocket. Axes are swapped"),
            std::string::npos)
      << bench::axes_text(pitch);
  EXPECT_NE(bench::axes_text(pitch).find("The roll by 360 degrees was not seen"), std::string::npos);
  const bench::AxesResult yaw = result_of_turns([](sim::Vector3& turn) {
    std::swap(turn.x, turn.z);
    turn.x = -turn.x;
  });
  EXPECT_NE(bench::axes_text(yaw).find("sees the yaw: it lies across the rocket. Axes are swapped"), std::string::npos)
      << bench::axes_text(yaw);
}

TEST(BenchAxes, AWrongScaleIsNamedAndAUsualOneIsNot) {
  const bench::AxesResult wrong =
      result_of([](sim::Scenario& scenario) { scenario.vehicle.imu_feels.rate_scale_error = 0.05; });
  EXPECT_FALSE(wrong.right);
  EXPECT_NE(bench::axes_text(wrong).find("The scale is wrong: 360 degrees of roll were seen as 37"), std::string::npos)
      << bench::axes_text(wrong);
  EXPECT_TRUE(result_of([](sim::Scenario& s) { s.vehicle.imu_feels.rate_scale_error = 0.01; }).right);
}

TEST(BenchAxes, AGyroThatStandsAskewIsNamed) {
  const bench::AxesResult result = result_of_turns([](sim::Vector3& turn) { turn.x += 0.2 * turn.y; });
  EXPECT_FALSE(result.right);
  EXPECT_NE(bench::axes_text(result).find("askew by about 12 degrees"), std::string::npos) << bench::axes_text(result);
}

TEST(BenchAxes, ARocketThatNobodyTurnsIsNotJudged) {
  EXPECT_THROW((void)result_of([](sim::Scenario& scenario) { scenario.hand_turns.clear(); }), bench::NotTurned);
}

}  // namespace
}  // namespace fantail::sil
