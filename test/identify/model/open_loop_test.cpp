// SPDX-License-Identifier: MIT
#include "identify/model/open_loop.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "identify/model/brute_force.hpp"
#include "identify/model/planted.hpp"
#include "identify/model/roll_model.hpp"

namespace fantail::identify::model {
namespace {

// Row 24 of the oracle table. The record is noisy, so that no cell is better than the rest by more than it should be.
TEST(OpenLoopGrid, ItsTableIsThatOfBruteForceAndSoIsItsWinner) {
  const Planting planting{.node_time_s = {0.0, 2.0, 9.0}, .node_deg = {-1.0, -6.0, -5.0}, .seconds = 9.0};
  Record record = planted_record(planting);
  const std::uint64_t seed = 24;
  add_noise(record, {}, seed);
  SCOPED_TRACE(seed);
  const NodeTimes nodes = even_nodes(record, 4);
  const Grid grid;
  const GridResult fast = search_open_loop_grid(record, tasha, nodes, Start::measured, grid);
  const GridResult slow = search_by_brute_force(record, tasha, nodes, grid);
  ASSERT_EQ(fast.errors.mean_abs_angle_error_rad.size(), 1260U);
  double largest_deg = 0.0;
  for (std::size_t i = 0; i < 1260; ++i) {
    const double difference = fast.errors.mean_abs_angle_error_rad[i] - slow.errors.mean_abs_angle_error_rad[i];
    largest_deg = std::max(largest_deg, std::abs(difference) / radians_per_degree);
  }
  EXPECT_LT(largest_deg, 1e-6);
  EXPECT_EQ(fast.model.alpha_m2, slow.model.alpha_m2);
  EXPECT_EQ(fast.model.beta_m, slow.model.beta_m);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    EXPECT_NEAR(fast.model.node_rad[k], slow.model.node_rad[k], 1e-6 * radians_per_degree);
  }
}

TEST(OpenLoopGrid, TheDefaultIsThePublishedOneWithTheValueItsPrintLeftOut) {
  const Grid grid;
  EXPECT_EQ(grid.alpha_m2.values().size(), 60U);
  const std::vector<double> beta = grid.beta_m.values();
  EXPECT_EQ(beta.size(), 21U);
  EXPECT_NE(std::ranges::find(beta, 6.0), beta.end());
  EXPECT_EQ(beta.back(), 15.0);
}

TEST(OpenLoopGrid, AnAxisOfOneValueIsAllowed) { EXPECT_EQ((Axis{7.0, 7.0, 1.0}.values()), std::vector<double>{7.0}); }

TEST(OpenLoopGrid, ItsErrorsAreThoseOfTheModelItReturns) {
  Record record = planted_record({});
  add_noise(record, {}, 5);
  const GridResult found = search_open_loop_grid(record, tasha, even_nodes(record, 2), Start::measured, Grid{});
  const Simulation simulation = simulate_open_loop(record, tasha, found.model);
  const double least = *std::ranges::min_element(found.errors.mean_abs_angle_error_rad);
  EXPECT_NEAR(simulation.mean_abs_angle_error_rad, least, 1e-12);
}

}  // namespace
}  // namespace fantail::identify::model
