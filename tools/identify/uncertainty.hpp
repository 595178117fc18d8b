// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/estimate.hpp"

namespace fantail::identify {

/// Where a number lies with a probability of 95 %. Empty ends: the data do not bound it there.
struct Interval {
  std::optional<double> low;
  std::optional<double> high;
};

/// How well each number of a model is known from one record, if the model is right and its residual goes on as it was.
struct Uncertainty {
  /// In the order alpha, beta, nodes; in m2, m and radians.
  std::vector<double> standard_deviation{};
  Eigen::MatrixXd correlation{};
  std::vector<Interval> interval{};  ///< 95 %, from the standard deviations
  Interval alpha_profile_m2{};       ///< 95 %, from the profile of the likelihood: the one to trust for alpha
  double effective_samples = 0.0;    ///< independent samples that the correlated residual is worth
  double residual_rms_rad = 0.0;
  double residual_correlation_s = 0.0;  ///< over which time the residual remembers itself
  bool alpha_identifiable = false;
  bool beta_identifiable = false;
  std::string verdict{};  ///< a sentence: "alpha is not identifiable from this window: no excitation", ...
};

}  // namespace fantail::identify
