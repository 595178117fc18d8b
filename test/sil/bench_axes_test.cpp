// SPDX-License-Identifier: MIT
// The whole way from hands that turn a rocket to the verdict. What a sensor can have wrong is in axes_verdict_test;
// here a person turns it wrong, and the rates are as a real gyro gives them.
#include <functional>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "bench/axes.hpp"
#include "core/flight_plan_members.hpp"
#include "sil/bench_at_world.hpp"

namespace fantail::sil {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

bench::TurnsSeen turns_of(const std::function<void(sim::Scenario&)>& change) {
  sim::Scenario scenario = input::load_scenario("bench_axes", {});
  change(scenario);
  BenchAtWorld place{std::move(scenario)};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  return bench::watch_turns(place, link, [](const bench::AskedTurn&) {});
}

bench::AxesResult result_of(const std::function<void(sim::Scenario&)>& change) {
  return bench::judge_axes(turns_of(change));
}

void expect_said(const bench::AxesResult& result, const std::string& words) {
  EXPECT_FALSE(result.right);
  EXPECT_NE(bench::axes_text(result).find(words), std::string::npos) << bench::axes_text(result);
}

TEST(BenchAxes, RightSensorsPassAndSeeEachTurn) {
  const bench::AxesResult result = result_of([](sim::Scenario&) {});
  EXPECT_TRUE(result.right) << bench::axes_text(result);
  EXPECT_NEAR(result.roll_rad.x, 360.0 * degree, 1.0 * degree);
  EXPECT_NEAR(result.roll_rad.y, 0.0, 0.5 * degree);
  EXPECT_NEAR(result.tilts[0].gyro.y_rad, 90.0 * degree, 0.5 * degree);
  EXPECT_NEAR(result.tilts[0].gyro.z_rad, 0.0, 0.5 * degree);
  EXPECT_NEAR(result.tilts[1].gyro.z_rad, 90.0 * degree, 0.5 * degree);
  for (const auto& tilt : result.tilts[1].accelerometer) {
    ASSERT_TRUE(tilt);
    EXPECT_NEAR(tilt->z_rad, 90.0 * degree, 3.0 * degree);
  }
}

TEST(BenchAxes, APersonMayRollTheRocketWhileLayingItDown) {
  const bench::AxesResult result = result_of([](sim::Scenario& scenario) {
    scenario.hand_turns[1].angle_rad.x = 40.0 * degree;
    scenario.hand_turns[1].angle_rad.z = -30.0 * degree;
    scenario.hand_turns[2].angle_rad.x = -40.0 * degree;
    scenario.hand_turns[2].angle_rad.z = 30.0 * degree;
  });
  EXPECT_TRUE(result.right) << bench::axes_text(result);
}

TEST(BenchAxes, ARollToTheWrongSideIsCalledReversed) {
  expect_said(result_of([](sim::Scenario& s) { s.hand_turns[0].angle_rad.x = -360.0 * degree; }),
              "The roll is reversed");
}

TEST(BenchAxes, AWrongScaleIsNamedAndAUsualOneIsNot) {
  const auto with_error = [](double error) {
    return result_of([error](sim::Scenario& s) { s.vehicle.imu_feels.rate_scale_error = error; });
  };
  const bench::AxesResult wrong = with_error(0.07);
  expect_said(wrong, "360 degrees of roll were seen as 38");
  expect_said(wrong, "Of a turn about z the gyro sees 107 % of what the accelerometer of the IMU sees.");
  EXPECT_TRUE(with_error(0.01).right);
}

TEST(BenchAxes, AnImuMountedOtherwiseThanThePlanBelievesIsNamedAndItsLinesMakeItRight) {
  using core::SensorAxis;
  const auto built_otherwise = [](sim::Scenario& s) {
    s.vehicle.imu.mounting = {.to_nose = SensorAxis::minus_y, .along_y = SensorAxis::plus_x};
  };
  const bench::TurnsSeen seen = turns_of(built_otherwise);
  expect_said(bench::judge_axes(seen), "its axes are swapped");
  const auto found = bench::mounting_of(seen, core::default_plan().sensors);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->imu.to_nose, SensorAxis::minus_y);
  const bench::AxesResult again = result_of([&](sim::Scenario& s) {
    built_otherwise(s);
    s.plan.sensors = *found;
  });
  EXPECT_TRUE(again.right) << bench::axes_text(again);
}

TEST(BenchAxes, ARocketThatNobodyTurnsIsNotJudged) {
  EXPECT_THROW((void)result_of([](sim::Scenario& scenario) { scenario.hand_turns.clear(); }), bench::NotTurned);
}

TEST(BenchAxes, ATurnBeyondTheGyrosRangeIsNotJudged) {
  try {
    (void)result_of([](sim::Scenario& s) { s.hand_turns[0].duration_s = 0.25; });
    FAIL() << "judged";
  } catch (const bench::NotTurned& error) {
    EXPECT_STREQ(error.what(), "the rocket was turned faster than its gyro can measure");
  }
}

}  // namespace
}  // namespace fantail::sil
