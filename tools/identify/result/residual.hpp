// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

#include "identify/model/roll_model.hpp"
#include "identify/result/findings.hpp"

namespace fantail::identify::result {

/// What a residual looks like over time: white noise, and noise that is forgotten exponentially, on top of each other.
/// That covers a noisy gyro, one whose integral wanders, and a model that is not quite right.
struct ResidualNoise {
  double variance_rad2 = 0.0;
  double white_share = 1.0;    ///< of the variance
  double correlation_s = 0.0;  ///< time constant of the rest; above 0 unless white_share is 1

  /// Its covariance matrix times each column. Linear in the number of samples.
  [[nodiscard]] Eigen::MatrixXd covariance_times(std::span<const double> time_s, const Eigen::MatrixXd& columns) const;

  /// How many independent samples say as much about a mean as these do.
  [[nodiscard]] double effective_samples(std::span<const double> time_s) const;
};

/// The most likely one (restricted maximum likelihood: what the fit took out of the residual is not mistaken for
/// quiet). `explaining`: everything that was fitted, linearised, a row a sample.
[[nodiscard]] ResidualNoise estimate_noise(std::span<const double> time_s, const Eigen::VectorXd& residual,
                                           const Eigen::MatrixXd& explaining);

/// How much of the motion a model leaves in the roll rate, root mean square over root mean square.
[[nodiscard]] double share_left(const model::Record& record, const model::Simulation& simulation);

/// A misfit() of half of the motion or more: whatever the angle says, the rate contradicts it.
[[nodiscard]] bool is_refuted(const model::Record& record, const Identification& result);

/// A sentence when the model leaves motion, not noise. The fit asks only for the angle, so the rate is a witness of its
/// own: what a gyro adds is gone within 10 ms, what a model lacks (a node, a lag, a canard that hits a wake) is not. No
/// interval covers such a lack. Residuals below a hundredth of the rate itself are not worth a word.
[[nodiscard]] std::optional<std::string> misfit(const model::Record& record, const Identification& result);

/// Is the residual of the roll rate white, and has it to do with the canards? A right model leaves neither.
[[nodiscard]] ResidualTests test_residual(const model::Record& record, const model::Simulation& simulation);

}  // namespace fantail::identify::result
