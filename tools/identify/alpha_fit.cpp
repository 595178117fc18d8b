// SPDX-License-Identifier: MIT
#include "identify/alpha_fit.hpp"

#include <cmath>

namespace fantail::identify {
namespace {

// The free motion's column becomes what is to be explained.
Eigen::MatrixXd responses(const ResponseBasis& basis, double alpha_m2) {
  Eigen::MatrixXd angles;
  basis.respond(alpha_m2, angles);
  const auto free = static_cast<Eigen::Index>(basis.free_column());
  angles.col(free) = basis.measured_rad() - angles.col(free);
  return angles;
}

constexpr Eigen::Index canard_side = 0;
constexpr Eigen::Index measured_side = 1;

}  // namespace

AlphaFit::AlphaFit(const ResponseBasis& basis, double alpha_m2)
    : alpha_m2_{alpha_m2},
      nodes_{static_cast<Eigen::Index>(basis.nodes())},
      angles_{responses(basis, alpha_m2)},
      fit_{angles_, static_cast<Eigen::Index>(basis.canard_column())} {}

std::optional<double> AlphaFit::best_beta_m() const {
  constexpr double explained = 1e-6;
  const double squared = canard_rest().squaredNorm();
  if (!(std::sqrt(squared) > explained * fit_.length_before(canard_rest(), canard_side))) {
    return std::nullopt;
  }
  return canard_rest().dot(rest()) / squared;
}

double AlphaFit::least_squares_rad2() const {
  const auto beta_m = best_beta_m();
  return (rest() - beta_m.value_or(0.0) * canard_rest()).squaredNorm();
}

std::vector<double> AlphaFit::mean_abs_error_rad(const Axis& beta_m) const {
  // A few rows at a time stay in registers while they go along the axis.
  constexpr Eigen::Index together = 8;
  using Rows = Eigen::Array<double, together, 1>;
  std::vector<double> sums(beta_m.values().size(), 0.0);
  const auto add = [&](auto error, const auto& change) {
    for (double& sum : sums) {
      sum += error.abs().sum();
      error -= change;
    }
  };
  const Eigen::Index rows = angles_.rows();
  Eigen::Index i = 0;
  for (; i + together <= rows; i += together) {
    const Rows canard = canard_rest().segment<together>(i);
    add(Rows{rest().segment<together>(i).array() - beta_m.first * canard}, Rows{beta_m.step * canard});
  }
  for (; i < rows; ++i) {
    using Row = Eigen::Array<double, 1, 1>;
    add(Row{rest()(i) - beta_m.first * canard_rest()(i)}, Row{beta_m.step * canard_rest()(i)});
  }
  for (double& sum : sums) {
    sum /= static_cast<double>(rows);
  }
  return sums;
}

Model AlphaFit::model(double beta_m, const NodeTimes& node_time_s) const {
  const Eigen::VectorXd all = fit_.coefficients(measured_side) - beta_m * fit_.coefficients(canard_side);
  Model model{.alpha_m2 = alpha_m2_, .beta_m = beta_m, .node_time_s = node_time_s, .node_rad = {}, .initial = {}};
  for (Eigen::Index k = 0; k < nodes_; ++k) {
    model.node_rad.push_back(all(k) / beta_m);
  }
  for (Eigen::Index k = nodes_; k < all.size(); k += 2) {
    model.initial.push_back({.angle_rad = all(k), .rate_rad_s = all(k + 1)});
  }
  return model;
}

}  // namespace fantail::identify
