// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "degree.hpp"
#include "identify/closed_loop/runs.hpp"
#include "identify/identification.hpp"
#include "identify/model/planted.hpp"
#include "seed.hpp"

namespace fantail::identify {
namespace {

using namespace closed_loop;
using namespace model;
using namespace result;

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

// How many of the stated intervals held the planted alpha, beta and disturbance. A record with the options to ask of it
// for each seed.
template <class Recorded>
void expect_coverage(const paper::Loop& loop, const Recorded& recorded) {
  const std::uint64_t first_seed = test::seed(1);
  const std::vector<double> true_numbers = truth(loop, {0.0}).numbers();
  std::array<int, 3> inside{};
  std::array<double, 3> mean{};
  for (int i = 0; i < records(); ++i) {
    const Record record = recorded(first_seed + static_cast<std::uint64_t>(i));
    Options options = closed_loop_options(loop, {0.0});
    options.grid = {.alpha_m2 = {15.0, 35.0, 10.0}, .beta_m = {8.0, 10.0, 2.0}};
    const Identification found = identify(record, paper::airframe(loop), options);
    for (std::size_t k = 0; k < inside.size(); ++k) {
      const Interval& interval = found.uncertainty->interval[k];
      inside[k] += *interval.low <= true_numbers[k] && true_numbers[k] <= *interval.high ? 1 : 0;
      mean[k] += found.model.numbers()[k] / records();
    }
  }
  fmt::print("of {} records: alpha {}, beta {}, disturbance {}; means {:.3f} m2, {:.4f} m, {:.4f} deg\n", records(),
             inside[0], inside[1], inside[2], mean[0], mean[1], mean[2] / degree);
  // Three standard deviations below 95 %.
  const double least = 0.95 * records() - 3.0 * std::sqrt(0.95 * 0.05 * records());
  for (const int count : inside) {
    EXPECT_GE(count, least);
  }
}

class ClosedLoopCoverage : public testing::TestWithParam<double> {};  // correlation time of the noise, s

TEST_P(ClosedLoopCoverage, ThePlantedNumbersLieInTheStatedIntervals) {
  const paper::Loop loop = second_launch_with_chirp();
  const Record quiet = closed_loop_record(loop, 4.0, 10);
  expect_coverage(loop, [&quiet](std::uint64_t seed) {
    Record record = quiet;
    add_noise(record, {.angle_deg = 0.3, .correlation_s = GetParam()}, seed);
    return record;
  });
}

INSTANTIATE_TEST_SUITE_P(Noises, ClosedLoopCoverage, testing::Values(0.0, 0.03));

// Noise that the law answers to, and that its estimate of the offset is made of.
class ClosedLoopCoverageOfModes : public testing::TestWithParam<const char*> {};

TEST_P(ClosedLoopCoverageOfModes, ThePlantedNumbersLieInTheStatedIntervals) {
  const std::string mode = GetParam();
  const paper::Loop published = second_launch_with_chirp();
  const paper::Loop loop = mode == "integral"   ? with_integral(published)
                           : mode == "observer" ? with_observer(published)
                           : mode == "schedule" ? with_schedule(with_integral(published))
                                                : published;
  expect_coverage(loop, [&loop](std::uint64_t seed) { return closed_loop_record(with_noise(loop, seed), 4.0, 2); });
}

INSTANTIATE_TEST_SUITE_P(Modes, ClosedLoopCoverageOfModes,
                         testing::Values("published", "integral", "observer", "schedule"));

}  // namespace
}  // namespace fantail::identify
