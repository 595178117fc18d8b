// SPDX-License-Identifier: MIT
#include "identify/sensitivities.hpp"

#include "identify/response_basis.hpp"

namespace fantail::identify {

using Eigen::Index;

Sensitivities open_loop_sensitivities(const Record& record, const Airframe& airframe, const Model& model) {
  const ResponseBasis basis{record, airframe, model.node_time_s, Start::fitted};
  const auto nodes = static_cast<Index>(basis.nodes());
  const auto segments = static_cast<Index>(record.segment_begin.size());
  const auto canard = static_cast<Index>(basis.canard_column());

  Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(static_cast<Index>(basis.columns()));
  for (Index k = 0; k < nodes; ++k) {
    coefficients(k) = model.beta_m * model.node_rad[static_cast<std::size_t>(k)];
  }
  for (Index s = 0; s < segments; ++s) {
    coefficients(nodes + 2 * s) = model.initial[static_cast<std::size_t>(s)].angle_rad;
    coefficients(nodes + 2 * s + 1) = model.initial[static_cast<std::size_t>(s)].rate_rad_s;
  }
  coefficients(canard) = model.beta_m;

  Sensitivities result;
  const auto samples = static_cast<Index>(basis.samples());
  result.numbers.resize(samples, 2 + nodes);
  Eigen::MatrixXd angles;
  const double step_m2 = 1e-4 * model.alpha_m2;
  basis.respond(model.alpha_m2 + step_m2, angles);
  result.numbers.col(0) = angles * coefficients;
  basis.respond(model.alpha_m2 - step_m2, angles);
  result.numbers.col(0) -= angles * coefficients;
  result.numbers.col(0) /= 2.0 * step_m2;

  basis.respond(model.alpha_m2, angles);
  result.numbers.col(1) = angles.col(canard) + angles.leftCols(nodes) * coefficients.head(nodes) / model.beta_m;
  result.numbers.rightCols(nodes) = model.beta_m * angles.leftCols(nodes);
  result.start_angle.resize(samples, segments);
  result.start_rate.resize(samples, segments);
  for (Index s = 0; s < segments; ++s) {
    result.start_angle.col(s) = angles.col(nodes + 2 * s);
    result.start_rate.col(s) = angles.col(nodes + 2 * s + 1);
  }
  return result;
}

}  // namespace fantail::identify
