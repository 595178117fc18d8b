// SPDX-License-Identifier: MIT
#include "identify/result/residual.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "identify/identification.hpp"
#include "identify/model/planted.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;

std::vector<double> uneven_times(std::size_t samples, double step_s) {
  std::vector<double> times;
  for (std::size_t i = 0; i < samples; ++i) {
    times.push_back(step_s * (static_cast<double>(i) + 0.3 * std::sin(static_cast<double>(i))));
  }
  return times;
}

Eigen::VectorXd wandering(const std::vector<double>& time_s, double variance, double correlation_s,
                          std::uint64_t seed) {
  std::mt19937_64 generator{seed};
  std::normal_distribution<double> gauss{0.0, std::sqrt(variance)};
  Eigen::VectorXd noise(static_cast<Eigen::Index>(time_s.size()));
  noise(0) = gauss(generator);
  for (Eigen::Index i = 1; i < noise.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double kept = std::exp(-(time_s[at] - time_s[at - 1]) / correlation_s);
    noise(i) = kept * noise(i - 1) + std::sqrt(1.0 - kept * kept) * gauss(generator);
  }
  return noise;
}

TEST(ResidualNoise, ItsProductIsThatOfTheWholeMatrix) {
  const std::vector<double> time_s = uneven_times(40, 0.01);
  const ResidualNoise noise{.variance_rad2 = 2.5, .white_share = 0.3, .correlation_s = 0.05};
  Eigen::MatrixXd whole(40, 40);
  for (Eigen::Index i = 0; i < 40; ++i) {
    for (Eigen::Index j = 0; j < 40; ++j) {
      const double apart = std::abs(time_s[static_cast<std::size_t>(i)] - time_s[static_cast<std::size_t>(j)]);
      whole(i, j) = 2.5 * (0.7 * std::exp(-apart / 0.05) + (i == j ? 0.3 : 0.0));
    }
  }
  const Eigen::MatrixXd columns = Eigen::MatrixXd::Random(40, 3);
  EXPECT_LT((noise.covariance_times(time_s, columns) - whole * columns).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ResidualNoise, ASampleInHundredsOfWhiteNoiseCountsInFull) {
  const std::vector<double> time_s = uneven_times(500, 0.01);
  EXPECT_DOUBLE_EQ(
      (ResidualNoise{.variance_rad2 = 1.0, .white_share = 1.0, .correlation_s = 0.0}.effective_samples(time_s)), 500.0);
  // (1 + e^-x) / (1 - e^-x) for x = 0.1: 20.02 neighbours say the same.
  const double x = 0.1;
  const ResidualNoise slow{
      .variance_rad2 = 1.0, .white_share = 0.0, .correlation_s = (time_s.back() - time_s.front()) / 499.0 / x};
  EXPECT_NEAR(slow.effective_samples(time_s), 500.0 * std::tanh(0.5 * x), 1e-9);
}

TEST(ResidualNoise, MemoryIsFoundInNoiseThatHasIt) {
  const std::vector<double> time_s = uneven_times(4000, 0.01);
  const std::uint64_t seed = 7;
  SCOPED_TRACE(seed);
  const Eigen::VectorXd noise = wandering(time_s, 4.0, 0.1, seed);
  const ResidualNoise found = estimate_noise(time_s, noise, Eigen::MatrixXd::Ones(noise.size(), 1));
  EXPECT_NEAR(found.correlation_s, 0.1, 0.025);
  EXPECT_NEAR(found.variance_rad2, 4.0, 1.0);
  EXPECT_LT(found.white_share, 0.1);
}

TEST(ResidualNoise, WhatTheFitTookOutIsNotMistakenForQuiet) {
  // A straight line through each short stretch of wandering noise takes most of it away. Restricted likelihood still
  // finds the variance on average; the residual's own mean square would be far too small.
  const std::vector<double> time_s = uneven_times(100, 0.01);
  Eigen::MatrixXd line(100, 2);
  for (Eigen::Index i = 0; i < 100; ++i) {
    line(i, 0) = 1.0;
    line(i, 1) = time_s[static_cast<std::size_t>(i)];
  }
  double plain = 0.0;
  double spread_of_mean = 0.0;
  constexpr int records = 200;
  for (int seed = 0; seed < records; ++seed) {
    const Eigen::VectorXd noise = wandering(time_s, 1.0, 0.1, 1000U + static_cast<std::uint64_t>(seed));
    const Eigen::VectorXd rest = noise - line * (line.transpose() * line).ldlt().solve(line.transpose() * noise);
    plain += rest.squaredNorm() / 100.0 / records;
    const ResidualNoise found = estimate_noise(time_s, rest, line);
    spread_of_mean += found.variance_rad2 * 100.0 / found.effective_samples(time_s) / records;
  }
  EXPECT_LT(plain, 0.75);
  // Variance of a sum of hundred: about 1 * 100 * (1 + e^-0.1) / (1 - e^-0.1) / 100 = 20 per sample.
  EXPECT_GT(spread_of_mean, 0.6 * 20.0);
  EXPECT_LT(spread_of_mean, 2.5 * 20.0);
}

// Two nodes for a planted roll with white noise at angle and rate.
std::optional<std::string> misfit_of(const Planting& planting, double rate_noise_deg_s = 1.0) {
  Record record = planted_record(planting);
  add_noise(record, {.angle_deg = 0.1, .rate_deg_s = rate_noise_deg_s}, 1);
  const Identification found = identify(record, tasha, {.with_uncertainty = false, .with_error_map = false});
  return misfit(record, found);
}

TEST(Misfit, IsNotSeenInNoise) {
  EXPECT_FALSE(misfit_of({}));
  EXPECT_FALSE(misfit_of({.sample_hz = 1000.0}));
}

TEST(Misfit, IsSeenWhenADisturbanceHasMoreKinksThanTheModel) {
  const Planting kinked{.node_time_s = {0.0, 1.0, 2.0, 3.0, 4.0}, .node_deg = {0.0, -7.0, -2.0, -8.0, -3.0}};
  EXPECT_TRUE(misfit_of(kinked));
  EXPECT_TRUE(misfit_of({.node_time_s = kinked.node_time_s, .node_deg = kinked.node_deg, .sample_hz = 1000.0}));
}

TEST(Misfit, OfAHundredthIsNotWorthAWord) { EXPECT_FALSE(misfit_of({}, 0.0)); }

}  // namespace
}  // namespace fantail::identify::result
