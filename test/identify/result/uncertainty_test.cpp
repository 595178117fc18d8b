// SPDX-License-Identifier: MIT
#include "identify/result/uncertainty.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "identify/identification.hpp"
#include "identify/model/open_loop.hpp"
#include "identify/model/planted.hpp"
#include "identify/model/roll_model.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;

Identification of(const Planting& planting, const Noise& noise, std::size_t intervals) {
  Record record = planted_record(planting);
  add_noise(record, noise, 3);
  return identify(record, tasha, {.nodes = EvenNodes{intervals}, .with_error_map = false});
}

TEST(Uncertainty, CanardsThatMoveMakeBothNumbersKnown) {
  const Identification found = of({}, {.angle_deg = 0.2}, 1);
  EXPECT_TRUE(found.uncertainty->alpha_identifiable);
  EXPECT_TRUE(found.uncertainty->beta_identifiable);
}

TEST(Uncertainty, CanardsThatStandStillAreSaidToExciteNothing) {
  // Rolling steadily from the start, beta v u / alpha = -90 deg/s: a rate that dies away would tell alpha, too.
  const Identification found = of({.canard_amplitude_deg = 0.02, .start_rate_deg_s = -90.0}, {.angle_deg = 0.3}, 4);
  EXPECT_FALSE(found.uncertainty->alpha_identifiable);
  EXPECT_FALSE(found.uncertainty->beta_identifiable);
  EXPECT_NE(found.uncertainty->verdict.find("too little excitation"), std::string::npos) << found.uncertainty->verdict;
}

// The beta that is written then is none that was found.
TEST(Uncertainty, CanardsThatDidWhatTheNodesCouldHaveDoneLeaveBetaUnknownHoweverTheRocketRolled) {
  for (const double trim_deg : {0.0, 2.0}) {
    for (const bool start_fitted : {false, true}) {
      Record record = planted_record({.node_deg = {3.0}, .canard_amplitude_deg = 0.0});
      std::ranges::fill(record.canard_rad, radians_per_degree * trim_deg);
      add_noise(record, {.angle_deg = 0.3}, 1);
      const Identification found = identify(
          record, tasha,
          {.nodes = NodeTimes{0.0}, .start = start_fitted ? Start::fitted : Start::measured, .with_error_map = false});
      EXPECT_FALSE(found.uncertainty->beta_identifiable) << found.uncertainty->standard_deviation[1];
      EXPECT_TRUE(found.uncertainty->alpha_identifiable);
      EXPECT_NE(found.uncertainty->verdict.find("no excitation"), std::string::npos) << found.uncertainty->verdict;
    }
  }
}

TEST(Uncertainty, MoreNoiseMeansWiderIntervalsInProportion) {
  // The same seed, so the same noise but for its size.
  const Identification quiet = of({}, {.angle_deg = 0.02, .rate_deg_s = 0.05}, 1);
  const Identification loud = of({}, {.angle_deg = 0.20, .rate_deg_s = 0.5}, 1);
  EXPECT_NEAR(loud.uncertainty->standard_deviation[0] / quiet.uncertainty->standard_deviation[0], 10.0, 1.5);
}

TEST(Uncertainty, InWhiteNoiseItIsTheCramerRaoBound) {
  const Planting planting{.sample_hz = 400.0};
  Record record = planted_record(planting);
  add_noise(record, {.angle_deg = 0.3, .rate_deg_s = 1.0}, 11);
  const Options options{.nodes = EvenNodes{1}, .start = Start::fitted, .with_error_map = false};
  const Identification found = identify(record, tasha, options);
  Sensitivities all = open_loop_sensitivities(record, tasha, found.model);
  Eigen::MatrixXd with_starts(all.numbers.rows(), all.numbers.cols() + 2);
  with_starts << all.numbers, all.start_angle, all.start_rate;
  all.numbers = with_starts;
  const Eigen::VectorXd bound = cramer_rao_standard_deviations(all, 0.3 * radians_per_degree);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(found.uncertainty->standard_deviation[k], bound(static_cast<Eigen::Index>(k)),
                0.15 * bound(static_cast<Eigen::Index>(k)))
        << k;
  }
}

TEST(Uncertainty, ExcitationIsWhatTheNodesCouldNotHaveDone) {
  Record record = planted_record({});
  for (std::size_t i = 0; i < record.size(); ++i) {
    record.canard_rad[i] = 0.01 + 0.02 * record.time_s[i];
  }
  EXPECT_NEAR(excitation_rad(record, even_nodes(record, 1)), 0.0, 1e-12);
  for (std::size_t i = 0; i < record.size(); ++i) {
    record.canard_rad[i] += (i % 2 == 0 ? 0.01 : -0.01);
  }
  EXPECT_NEAR(excitation_rad(record, even_nodes(record, 1)), 0.01, 1e-4);
}

TEST(Uncertainty, ARecordWithoutNoiseIsKnownAsWellAsItsSteps) {
  const Identification found = of({}, {.angle_deg = 0.0, .rate_deg_s = 0.0}, 1);
  EXPECT_LT(found.uncertainty->standard_deviation[0], 0.1);
  EXPECT_TRUE(found.uncertainty->alpha_identifiable);
}

}  // namespace
}  // namespace fantail::identify::result
