// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "identify/orthogonal_fit.hpp"
#include "identify/response_basis.hpp"

namespace fantail::identify {

/// The open-loop fit at one alpha. The best nodes for a beta leave the error  rest - beta canard_rest,  where both
/// parts are what the nodes cannot explain: so one factorisation serves every beta.
class AlphaFit {
 public:
  AlphaFit(const ResponseBasis& basis, double alpha_m2);

  [[nodiscard]] double alpha_m2() const { return alpha_m2_; }

  /// Of least squares. Empty when the nodes explain all that the canards did (to a millionth): then any beta is as
  /// good.
  [[nodiscard]] std::optional<double> best_beta_m() const;

  /// The sum of squared angle errors at the best beta, or at any when there is no best.
  [[nodiscard]] double least_squares_rad2() const;

  /// The mean absolute angle error at each value of the axis.
  [[nodiscard]] std::vector<double> mean_abs_error_rad(const Axis& beta_m) const;

  /// beta_m not zero. Initial states are in the model only if the basis has columns for them.
  [[nodiscard]] Model model(double beta_m, const NodeTimes& node_time_s) const;

 private:
  [[nodiscard]] auto rest() const { return angles_.col(angles_.cols() - 1); }
  [[nodiscard]] auto canard_rest() const { return angles_.col(angles_.cols() - 2); }

  double alpha_m2_;
  Eigen::Index nodes_;
  Eigen::MatrixXd angles_;
  OrthogonalFit fit_;
};

}  // namespace fantail::identify
