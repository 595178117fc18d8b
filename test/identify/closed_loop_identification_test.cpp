// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "identify/closed_loop/runs.hpp"
#include "identify/identification.hpp"
#include "identify/model/planted.hpp"
#include "seed.hpp"

namespace fantail::identify {
namespace {

using namespace closed_loop;
using namespace model;
using namespace result;

constexpr double degree = paper::radians_per_degree;

Options closed_loop_options(const paper::Loop& loop, const NodeTimes& nodes) {
  return {.nodes = nodes, .closed_loop = controller_of(loop), .with_error_map = false};
}

TEST(ClosedLoopIdentification, BothMethodsFindThePlantedModel) {
  const paper::Loop loop = second_launch_with_chirp();
  const Record record = closed_loop_record(loop, 9.0, 1);
  Options options = closed_loop_options(loop, {0.0, 9.0});
  options.with_error_map = true;
  const Identification continuous = identify(record, paper::airframe(loop), options);
  EXPECT_EQ(continuous.loop, Loop::closed);
  expect_same(continuous.model, truth(loop, {0.0, 9.0}));
  EXPECT_LT(continuous.simulation.mean_abs_angle_error_rad, 1e-4 * degree);
  ASSERT_TRUE(continuous.error_map);
  EXPECT_EQ(continuous.error_map->mean_abs_angle_error_rad.size(), 1260U);

  options.method = Method::grid;
  const Identification grid = identify(record, paper::airframe(loop), options);
  EXPECT_EQ(grid.model.alpha_m2, 23.0);
  EXPECT_EQ(grid.model.beta_m, 9.0);
}

TEST(ClosedLoopIdentification, SaysHowWellTheNumbersAreKnown) {
  const paper::Loop loop = second_launch_with_chirp();
  Record record = closed_loop_record(loop, 6.0, 10);
  add_noise(record, {.angle_deg = 0.3, .correlation_s = 0.0}, 11);
  record.canard_rad.clear();
  const Identification found = identify(record, paper::airframe(loop), closed_loop_options(loop, {0.0, 6.0}));
  ASSERT_TRUE(found.uncertainty);
  const Uncertainty& uncertainty = *found.uncertainty;
  ASSERT_EQ(uncertainty.standard_deviation.size(), 4U);
  EXPECT_TRUE(uncertainty.alpha_identifiable) << uncertainty.verdict;
  ASSERT_TRUE(uncertainty.alpha_profile_m2.low && uncertainty.alpha_profile_m2.high);
  EXPECT_LT(*uncertainty.alpha_profile_m2.low, found.model.alpha_m2);
  EXPECT_GT(*uncertainty.alpha_profile_m2.high, found.model.alpha_m2);
  EXPECT_NEAR(uncertainty.residual_rms_rad / degree, 0.3, 0.05);
}

TEST(ClosedLoopIdentification, AsManyNodesAsItTakes) {
  const paper::Loop loop = second_launch();
  Record record = closed_loop_record(loop, 6.0, 10);
  Options options = closed_loop_options(loop, {});
  options.nodes = AutomaticNodes{.most = 2};
  options.with_uncertainty = false;
  add_noise(record, {.angle_deg = 0.3, .correlation_s = 0.0}, 12);
  const Identification found = identify(record, paper::airframe(loop), options);
  ASSERT_EQ(found.node_trials.size(), 2U);
  EXPECT_EQ(found.model.node_time_s.size(), 2U);
}

int records() {
  const char* asked = std::getenv("FANTAIL_RECORDS");  // NOLINT(concurrency-mt-unsafe): there is one thread
  return asked != nullptr ? std::atoi(asked) : 40;
}

class ClosedLoopCoverage : public testing::TestWithParam<double> {};  // correlation time of the noise, s

TEST_P(ClosedLoopCoverage, ThePlantedNumbersLieInTheStatedIntervals) {
  const paper::Loop loop = second_launch_with_chirp();
  const Record quiet = closed_loop_record(loop, 4.0, 10);
  const std::uint64_t first_seed = test::seed(1);
  std::array<int, 3> inside{};
  for (int i = 0; i < records(); ++i) {
    Record record = quiet;
    add_noise(record, {.angle_deg = 0.3, .correlation_s = GetParam()}, first_seed + static_cast<std::uint64_t>(i));
    Options options = closed_loop_options(loop, {0.0});
    options.grid = {.alpha_m2 = {15.0, 35.0, 10.0}, .beta_m = {8.0, 10.0, 2.0}};
    const Identification found = identify(record, paper::airframe(loop), options);
    const std::vector<double> true_numbers = truth(loop, {0.0}).numbers();
    for (std::size_t k = 0; k < inside.size(); ++k) {
      const Interval& interval = found.uncertainty->interval[k];
      inside[k] += *interval.low <= true_numbers[k] && true_numbers[k] <= *interval.high ? 1 : 0;
    }
  }
  fmt::print("of {} records: alpha {}, beta {}, disturbance {}\n", records(), inside[0], inside[1], inside[2]);
  // Three standard deviations below 95 %.
  const double least = 0.95 * records() - 3.0 * std::sqrt(0.95 * 0.05 * records());
  for (const int count : inside) {
    EXPECT_GE(count, least);
  }
}

INSTANTIATE_TEST_SUITE_P(Noises, ClosedLoopCoverage, testing::Values(0.0, 0.03));

}  // namespace
}  // namespace fantail::identify
