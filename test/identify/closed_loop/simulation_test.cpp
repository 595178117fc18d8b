// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "degree.hpp"
#include "identify/closed_loop/closed_loop.hpp"
#include "identify/closed_loop/runs.hpp"
#include "text/error.hpp"

namespace fantail::identify::closed_loop {
namespace {

using namespace model;

double most_apart(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::abs(a[i] - b[i]));
  }
  return most;
}

// The same loop stepped by another program, a millisecond at a time.
TEST(ClosedLoopModel, FliesLikeTheSimulatedRocket) {
  for (const bool chirp : {false, true}) {
    const paper::Loop loop = chirp ? second_launch_with_chirp() : first_launch();
    const NodeTimes nodes = chirp ? NodeTimes{0.0} : first_launch_nodes();
    const Record record = closed_loop_record(loop, 9.0, 1);
    const Simulation flown = simulate(record, paper::airframe(loop), controller_of(loop), truth(loop, nodes));
    EXPECT_LT(most_apart(flown.roll_angle_rad, record.roll_angle_rad), 1e-6);
    EXPECT_LT(most_apart(flown.roll_rate_rad_s, record.roll_rate_rad_s), 1e-5);
    EXPECT_LT(flown.mean_abs_angle_error_rad, 1e-7);
    const std::vector<paper::Point> points = paper::run(loop, 9.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_NEAR(flown.canard_rad[i], points[i].command_deg * degree, 1e-5) << points[i].time_s;
    }
  }
}

// What the law took off its command, and the speed by which it chose its gains, are the log's; the rest is flown.
TEST(ClosedLoopModel, FliesLikeTheSimulatedRocketWithEachModeOfTheLaw) {
  const paper::Loop published = second_launch_with_chirp();
  for (const paper::Loop& loop : {with_integral(published), with_observer(published), with_schedule(published),
                                  with_schedule(with_integral(first_launch()))}) {
    const NodeTimes nodes = loop.control_from_s > 0.0 ? first_launch_nodes() : NodeTimes{0.0};
    const Record record = closed_loop_record(loop, 9.0, 1);
    const Simulation flown = simulate(record, paper::airframe(loop), controller_of(loop), truth(loop, nodes));
    EXPECT_LT(most_apart(flown.roll_angle_rad, record.roll_angle_rad), 1e-6);
    EXPECT_LT(most_apart(flown.roll_rate_rad_s, record.roll_rate_rad_s), 1e-5);
    Record published_log = record;
    published_log.offset_estimate_rad.clear();
    const Control published_law{.controller = loop.controller, .servo_lag_s = 0.020};
    const Simulation other = simulate(published_log, paper::airframe(loop), published_law, truth(loop, nodes));
    EXPECT_GT(most_apart(other.roll_angle_rad, record.roll_angle_rad), 1.0 * degree);
  }
}

// A speed that is only known to be at least this gets the last row of the schedule, as in flight.
TEST(ClosedLoopModel, WhereTheSpeedIsALowerBoundTheLastGainsCount) {
  paper::Loop loop = with_schedule(second_launch());
  Record record = closed_loop_record(loop, 2.0, 1);
  record.law_speed_is_bound_s = 0.0;
  const RollModel model = truth(loop, {0.0});
  const Simulation bound = simulate(record, paper::airframe(loop), controller_of(loop), model);
  loop.controller.proportional_gain *= 0.75F;
  loop.controller.derivative_gain_s *= 0.75F;
  loop.gain_schedule = {};
  const Simulation last_row = simulate(record, paper::airframe(loop), controller_of(loop), model);
  EXPECT_EQ(bound.canard_rad, last_row.canard_rad);
}

TEST(ClosedLoopModel, ASlowLogIsFlownAtTheControllersOwnPace) {
  const paper::Loop loop = first_launch();
  const Record record = closed_loop_record(loop, 9.0, 10);
  const Simulation flown =
      simulate(record, paper::airframe(loop), controller_of(loop), truth(loop, first_launch_nodes()));
  ASSERT_EQ(flown.roll_angle_rad.size(), record.size());
  EXPECT_LT(most_apart(flown.roll_angle_rad, record.roll_angle_rad), 0.01 * degree);
}

// Four samples a millisecond: the law still runs once in each, so the same rocket comes out.
TEST(ClosedLoopModel, ALogFasterThanTheControllerChangesNothing) {
  const paper::Loop loop = second_launch();
  const Record slow = closed_loop_record(loop, 3.0, 1);
  Record fast;
  const auto refine = [&](const std::vector<double>& from, std::vector<double>& to, bool straight) {
    for (std::size_t i = 0; i + 1 < from.size(); ++i) {
      for (const double share : {0.0, 0.25, 0.5, 0.75}) {
        to.push_back(from[i] + (straight ? share * (from[i + 1] - from[i]) : 0.0));
      }
    }
    to.push_back(from.back());
  };
  refine(slow.time_s, fast.time_s, true);
  refine(slow.roll_angle_rad, fast.roll_angle_rad, true);
  refine(slow.roll_rate_rad_s, fast.roll_rate_rad_s, true);
  refine(slow.canard_rad, fast.canard_rad, true);
  refine(slow.speed_m_s, fast.speed_m_s, true);
  refine(slow.density_kg_m3, fast.density_kg_m3, true);
  refine(slow.reference_rad, fast.reference_rad, false);
  const RollModel model = truth(loop, {0.0});
  const Airframe airframe = paper::airframe(loop);
  const Simulation flown = simulate(slow, airframe, controller_of(loop), model);
  const Simulation finer = simulate(fast, airframe, controller_of(loop), model);
  for (std::size_t i = 0; i < slow.size(); ++i) {
    ASSERT_NEAR(finer.roll_angle_rad[4 * i], flown.roll_angle_rad[i], 1e-5) << slow.time_s[i];
    ASSERT_NEAR(finer.canard_rad[4 * i], flown.canard_rad[i], 1e-4) << slow.time_s[i];
  }
}

TEST(ClosedLoopModel, TheCommandIsZeroOutsideControl) {
  const paper::Loop loop = first_launch();
  const Record record = closed_loop_record(loop, 1.0, 1);
  const Simulation flown =
      simulate(record, paper::airframe(loop), controller_of(loop), truth(loop, first_launch_nodes()));
  for (std::size_t i = 0; i < record.size(); ++i) {
    ASSERT_EQ(flown.canard_rad[i] == 0.0, record.time_s[i] < 0.4195) << record.time_s[i];
  }
}

TEST(ClosedLoopModel, EachSegmentBeginsWithItsOwnState) {
  const paper::Loop loop = second_launch();
  Record record = closed_loop_record(loop, 2.0, 1);
  record.segment_begin = {0, 900};
  RollModel model = truth(loop, {0.0});
  model.initial.push_back({.angle_rad = 1.25, .rate_rad_s = -0.5});
  const Simulation flown = simulate(record, paper::airframe(loop), controller_of(loop), model);
  EXPECT_EQ(flown.roll_angle_rad[900], 1.25);
  EXPECT_EQ(flown.roll_rate_rad_s[900], -0.5);
  EXPECT_NEAR(flown.roll_angle_rad[899], record.roll_angle_rad[899], 1e-6);
}

void expect_refused(const Record& record, const Control& controller, text::ErrorKind fault, const std::string& word) {
  const paper::Loop loop = second_launch();
  try {
    (void)simulate(record, paper::airframe(loop), controller, truth(loop, {0.0}));
    FAIL() << "not refused: " << word;
  } catch (const text::Error& error) {
    EXPECT_EQ(error.kind(), fault);
    EXPECT_NE(std::string{error.what()}.find(word), std::string::npos) << error.what();
  }
}

TEST(ClosedLoopModel, RefusesWhatItCannotFly) {
  const paper::Loop loop = second_launch();
  const Record record = closed_loop_record(loop, 1.0, 10);
  Record no_reference = record;
  no_reference.reference_rad.clear();
  expect_refused(no_reference, controller_of(loop), text::ErrorKind::bad_data, "reference_deg");
  Record older = record;
  older.offset_estimate_rad.clear();
  expect_refused(older, controller_of(with_integral(loop)), text::ErrorKind::bad_data, "offset_estimate_deg");
  expect_refused(older, controller_of(with_observer(loop)), text::ErrorKind::bad_data, "the open loop does not");
  older.law_speed_m_s.clear();
  expect_refused(older, controller_of(with_schedule(loop)), text::ErrorKind::bad_data, "speed_m_s");
  EXPECT_NO_THROW((void)simulate(older, paper::airframe(loop), controller_of(loop), truth(loop, {0.0})));
  Control controller = controller_of(loop);
  controller.controller_period_s = 0.0;
  expect_refused(record, controller, text::ErrorKind::bad_configuration, "controller period");
  controller = controller_of(loop);
  controller.servo_lag_s = -0.01;
  expect_refused(record, controller, text::ErrorKind::bad_configuration, "servo lag");
}

}  // namespace
}  // namespace fantail::identify::closed_loop
