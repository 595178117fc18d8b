// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "degree.hpp"
#include "identify/closed_loop/closed_loop.hpp"
#include "identify/closed_loop/runs.hpp"
#include "identify/model/planted.hpp"

namespace fantail::identify::closed_loop {
namespace {

using namespace model;

Fit fit(const paper::Loop& loop, const Record& record, const NodeTimes& nodes, Start start = Start::measured) {
  return closed_loop::fit(record, paper::airframe(loop), controller_of(loop), nodes, start, Grid{});
}

TEST(ClosedLoopFit, FindsThePlantedSecondLaunch) {
  const NodeTimes nodes{0.0, 4.5, 9.0};
  for (const paper::Loop& loop : {second_launch(), second_launch_with_chirp()}) {
    expect_same(fit(loop, closed_loop_record(loop, 9.0, 1), nodes).model, truth(loop, nodes));
  }
}

TEST(ClosedLoopFit, FindsItInALogOfAHundredHertz) {
  const paper::Loop loop = second_launch();
  expect_same(fit(loop, closed_loop_record(loop, 9.0, 10), {0.0, 4.5}).model, truth(loop, {0.0, 4.5}), 5.0);
}

// At 100 Hz a chirp of 18 Hz has five samples a period. Between them it runs straight: held, it would be 5 ms late, and
// alpha would come out as 24.5.
TEST(ClosedLoopFit, AChirpInASlowLogIsNotLate) {
  const paper::Loop loop = second_launch_with_chirp();
  const RollModel found = fit(loop, closed_loop_record(loop, 9.0, 10), {0.0, 4.5}).model;
  EXPECT_NEAR(found.alpha_m2, 23.0, 0.3);
  EXPECT_NEAR(found.beta_m, 9.0, 0.05);
}

TEST(ClosedLoopFit, FindsThePlantedFirstLaunchThoughItsCanardsStoodAtTheLimit) {
  const paper::Loop loop = first_launch();
  const NodeTimes nodes = first_launch_nodes();
  expect_same(fit(loop, closed_loop_record(loop, 9.0, 10), nodes).model, truth(loop, nodes), 5.0);
}

TEST(ClosedLoopFit, FindsItWithoutEncoders) {
  const paper::Loop loop = second_launch();
  Record record = closed_loop_record(loop, 6.0, 10);
  record.canard_rad.clear();
  expect_same(fit(loop, record, {0.0}).model, truth(loop, {0.0}), 5.0);
}

TEST(ClosedLoopFit, AFittedStartForgivesAWrongFirstSample) {
  const paper::Loop loop = second_launch();
  Record record = closed_loop_record(loop, 6.0, 1);
  record.roll_angle_rad.front() += 2.0 * degree;
  record.roll_rate_rad_s.front() -= 20.0 * degree;
  const RollModel fitted = fit(loop, record, {0.0}, Start::fitted).model;
  expect_same(fitted, truth(loop, {0.0}), 10.0);
  EXPECT_NEAR(fitted.initial[0].angle_rad / degree, 0.0, 0.1);
  EXPECT_NEAR(fitted.initial[0].rate_rad_s / degree, -20.0, 1.0);
}

TEST(ClosedLoopFit, BehindAGapTheModelStartsAnew) {
  const paper::Loop loop = second_launch();
  Record record = closed_loop_record(loop, 6.0, 10);
  const auto cut = [](auto& values) { values.erase(values.begin() + 150, values.begin() + 190); };
  for (auto* values : {&record.time_s, &record.roll_angle_rad, &record.roll_rate_rad_s, &record.canard_rad,
                       &record.speed_m_s, &record.density_kg_m3, &record.reference_rad, &record.excitation_rad,
                       &record.offset_estimate_rad, &record.law_speed_m_s}) {
    cut(*values);
  }
  cut(record.in_control);
  record.segment_begin = {0, 150};
  const RollModel found = fit(loop, record, {0.0}).model;
  expect_same(found, truth(loop, {0.0}), 5.0);
  EXPECT_EQ(found.initial.size(), 2U);
}

// From far away a descent ends in the first hollow, where the canards are at their limit at the wrong times.
TEST(ClosedLoopFit, SeveralStartsFindWhatOneMisses) {
  const paper::Loop loop = first_launch();
  const Record record = closed_loop_record(loop, 9.0, 10);
  const NodeTimes nodes = first_launch_nodes();
  const Airframe airframe = paper::airframe(loop);
  const FirstGuess guess{record, airframe, nodes, Start::measured};
  Descent descent{record, airframe, controller_of(loop), nodes, Start::measured};
  const Fit one = descent.from(model_of(record, nodes, Start::measured, 30.0, 10.0, guess.at(30.0, 10.0)));
  const Fit several = fit(loop, record, nodes);
  EXPECT_GT(one.squares_rad2, 1000.0 * several.squares_rad2);
  EXPECT_GT(std::abs(one.model.alpha_m2 - 7.5), 2.0);
}

TEST(ClosedLoopFit, IsNeverWorseThanTheGridsBest) {
  const paper::Loop loop = first_launch();
  const Airframe airframe = paper::airframe(loop);
  const NodeTimes nodes = first_launch_nodes();
  const Grid grid{.alpha_m2 = {2.0, 20.0, 2.0}, .beta_m = {8.0, 13.0, 1.0}};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Record record = closed_loop_record(loop, 6.0, 10);
    add_noise(record, {.angle_deg = 1.0, .correlation_s = 0.3}, seed);
    const GridResult searched = search_grid(record, airframe, controller_of(loop), nodes, Start::measured, grid);
    Descent descent{record, airframe, controller_of(loop), nodes, Start::measured};
    const Fit found =
        closed_loop::fit(record, airframe, controller_of(loop), nodes, Start::measured, grid, searched.least_squares);
    EXPECT_LE(found.squares_rad2, descent.squares_rad2(searched.least_squares)) << "seed " << seed;
    EXPECT_LE(found.squares_rad2, descent.squares_rad2(searched.model)) << "seed " << seed;
  }
}

TEST(ClosedLoopFit, AHeldAlphaStaysAndTheRestMakesTheBestOfIt) {
  const paper::Loop loop = second_launch();
  const Record record = closed_loop_record(loop, 6.0, 10);
  Descent descent{record, paper::airframe(loop), controller_of(loop), {0.0}, Start::measured};
  RollModel begin = truth(loop, {0.0});
  const double at_truth = descent.from(begin, Alpha::held).squares_rad2;
  begin.alpha_m2 = 26.0;
  const Fit held = descent.from(begin, Alpha::held);
  EXPECT_EQ(held.model.alpha_m2, 26.0);
  EXPECT_GT(held.model.beta_m, 9.0);
  EXPECT_LT(held.squares_rad2, descent.squares_rad2(begin));
  EXPECT_GT(held.squares_rad2, at_truth);
}

}  // namespace
}  // namespace fantail::identify::closed_loop
