// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "identify/result/findings.hpp"

// Do several windows tell of one alpha and one beta?
namespace fantail::identify::result {

/// Damping (m2) and torque constant (m) with how well both are known.
struct Constants {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  double degrees_of_freedom = 0.0;  ///< that the covariance was found with
};

/// Of a result with an uncertainty.
[[nodiscard]] Constants constants_of(const Identification& result);

/// 95 %, from the covariance: of alpha (0) or beta (1).
[[nodiscard]] Interval interval_of(const Constants& constants, Eigen::Index which);

/// How far estimates are from their common mean, each weighed with its own covariance.
struct Agreement {
  double chi_square = 0.0;
  double limit = 0.0;  ///< estimates of the same two numbers are below it in 95 of 100 cases

  [[nodiscard]] bool agree() const { return chi_square <= limit; }
};

/// Differences of alpha and beta that are no larger, as a share of them, do not matter: a prediction has larger errors.
inline constexpr double no_matter = 0.02;

/// Of two or more. The limit is the quantile of the chi-square distribution, and wider where a covariance rests on few
/// degrees of freedom.
[[nodiscard]] Agreement agreement(const std::vector<Constants>& estimates);

/// Of two estimates, of which one may be exact: no covariance and endless degrees of freedom.
[[nodiscard]] Agreement difference(const Constants& a, const Constants& b);

}  // namespace fantail::identify::result
