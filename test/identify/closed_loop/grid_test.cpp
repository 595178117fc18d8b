// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "degree.hpp"
#include "identify/closed_loop/closed_loop.hpp"
#include "identify/closed_loop/runs.hpp"
#include "identify/model/planted.hpp"
#include "sim/random.hpp"

namespace fantail::identify::closed_loop {
namespace {

using namespace model;

TEST(ClosedLoopGrid, FindsThePlantedTunnelStepsExactly) {
  const NodeTimes nodes{0.0, 5.0};
  for (const std::size_t row : {0U, 3U, 4U}) {
    const paper::TunnelStep& step = paper::table_2[row];
    const paper::Loop loop = paper::tunnel_loop(step);
    const GridResult found = search_grid(closed_loop_record(loop, 5.0, 10), paper::airframe(loop), controller_of(loop),
                                         nodes, Start::measured, Grid{});
    EXPECT_EQ(found.model.alpha_m2, step.alpha_m2);
    EXPECT_EQ(found.model.beta_m, step.beta_m);
    EXPECT_NEAR(found.model.node_rad[0] / degree, step.disturbance_begin_deg, 0.01);
    EXPECT_NEAR(found.model.node_rad[1] / degree, step.disturbance_end_deg, 0.01);
  }
}

TEST(ClosedLoopGrid, FindsTheFirstLaunchBetweenItsNeighbours) {
  const paper::Loop loop = first_launch();
  const NodeTimes nodes = first_launch_nodes();
  const Grid grid{.alpha_m2 = {1.5, 20.5, 1.0}, .beta_m = {8.0, 12.0, 1.0}};
  const GridResult found = search_grid(closed_loop_record(loop, 9.0, 10), paper::airframe(loop), controller_of(loop),
                                       nodes, Start::measured, grid);
  expect_same(found.model, truth(loop, nodes), 5.0);
}

// Every cell against a descent of its own that goes on until nothing moves.
TEST(ClosedLoopGrid, EachCellHasItsOwnBestNodes) {
  const paper::Loop loop = second_launch_with_chirp();
  const Airframe airframe = paper::airframe(loop);
  const Control controller = controller_of(loop);
  const NodeTimes nodes{0.0, 3.0, 6.0};
  Record record = closed_loop_record(loop, 6.0, 10);
  add_noise(record, {.angle_deg = 0.5, .correlation_s = 0.3}, 7);
  const Grid grid{.alpha_m2 = {15.0, 30.0, 5.0}, .beta_m = {8.0, 10.0, 0.5}};
  const GridResult found = search_grid(record, airframe, controller, nodes, Start::measured, grid);

  const Course course = make_course(record, airframe, controller, nodes);
  LaneTrials<1> trials{course, {.initial = false, .model = false}};
  Plant plant;
  for (std::size_t i = 0; i < found.errors.alpha_m2.size(); ++i) {
    plant.set_alpha(course, found.errors.alpha_m2[i], Slopes::none);
    for (std::size_t j = 0; j < found.errors.beta_m.size(); ++j) {
      LevenbergMarquardt search{Eigen::VectorXd::Zero(3), {.relative_gain = 1e-13}};
      while (!search.finished()) {
        trials.set(0, found.errors.beta_m[j], search.trial());
        trials.fly_with_derivatives(plant);
        search.tell(trials.equations(0));
      }
      const RollModel best =
          model_of(record, nodes, Start::measured, found.errors.alpha_m2[i], found.errors.beta_m[j], search.best());
      const double mean_rad = simulate(record, airframe, controller, best).mean_abs_angle_error_rad;
      EXPECT_NEAR(found.errors.mean_abs_angle_error_rad[j * found.errors.alpha_m2.size() + i] / degree,
                  mean_rad / degree, 1e-3)
          << "alpha " << found.errors.alpha_m2[i] << ", beta " << found.errors.beta_m[j];
    }
  }
}

// The first launch has several hollows for the nodes of one alpha and beta. Sixty descents from all around know them.
TEST(ClosedLoopGrid, TheWinnerLiesInTheDeepestHollowOfItsCell) {
  const paper::Loop loop = first_launch();
  const Airframe airframe = paper::airframe(loop);
  const Control controller = controller_of(loop);
  const NodeTimes nodes = first_launch_nodes();
  const Grid grid{.alpha_m2 = {1.0, 20.0, 1.0}, .beta_m = {9.0, 11.0, 0.5}};
  for (const std::uint64_t seed : {1U, 3U, 5U}) {
    Record record = closed_loop_record(loop, 9.0, 20);
    add_noise(record, {.angle_deg = 0.3, .correlation_s = 0.5}, seed);
    const GridResult found = search_grid(record, airframe, controller, nodes, Start::measured, grid);

    const Course course = make_course(record, airframe, controller, nodes);
    LaneTrials<1> trials{course, {.initial = false, .model = false}};
    Plant plant;
    plant.set_alpha(course, found.model.alpha_m2, Slopes::none);
    const Eigen::VectorXd winner = unknown_of(found.model, Start::measured);
    trials.set(0, found.model.beta_m, winner);
    trials.fly(plant);
    const double squares_rad2 = trials.errors().squares(0);
    sim::Random random{seed, 0};
    for (int descent = 0; descent < 60; ++descent) {
      Eigen::VectorXd begin = winner;
      for (double& node_rad : begin) {
        node_rad += degree * random.gaussian();
      }
      LevenbergMarquardt search{begin, {}};
      while (!search.finished()) {
        trials.set(0, found.model.beta_m, search.trial());
        trials.fly_with_derivatives(plant);
        search.tell(trials.equations(0));
      }
      EXPECT_GE(search.squares(), squares_rad2 * (1.0 - 1e-3)) << "seed " << seed << ", descent " << descent;
    }
  }
}

TEST(ClosedLoopGrid, TheWinnerIsTheLeastOfTheMap) {
  const paper::Loop loop = second_launch();
  const Airframe airframe = paper::airframe(loop);
  Record record = closed_loop_record(loop, 4.0, 10);
  add_noise(record, {}, 3);
  const Grid grid{.alpha_m2 = {10.0, 40.0, 5.0}, .beta_m = {6.0, 12.0, 1.0}};
  const GridResult found = search_grid(record, airframe, controller_of(loop), {0.0, 4.0}, Start::fitted, grid);
  double least = found.errors.mean_abs_angle_error_rad.front();
  for (const double error : found.errors.mean_abs_angle_error_rad) {
    least = std::min(least, error);
  }
  const Simulation winner = simulate(record, airframe, controller_of(loop), found.model);
  EXPECT_NEAR(winner.mean_abs_angle_error_rad, least, 1e-9);
  const Simulation squares = simulate(record, airframe, controller_of(loop), found.least_squares);
  EXPECT_LE(squares.rms_angle_error_rad, winner.rms_angle_error_rad);
  EXPECT_GE(squares.mean_abs_angle_error_rad, winner.mean_abs_angle_error_rad);
}

}  // namespace
}  // namespace fantail::identify::closed_loop
