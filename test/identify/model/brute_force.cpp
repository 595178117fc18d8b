// SPDX-License-Identifier: MIT
#include "identify/model/brute_force.hpp"

#include <Eigen/Cholesky>

namespace fantail::identify::model {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd residual(const Record& record, const Airframe& airframe, const RollModel& model) {
  const Simulation simulation = simulate_open_loop(record, airframe, model);
  const auto samples = static_cast<Index>(record.size());
  return Eigen::Map<const VectorXd>(record.roll_angle_rad.data(), samples) -
         Eigen::Map<const VectorXd>(simulation.roll_angle_rad.data(), samples);
}

void fit_nodes(const Record& record, const Airframe& airframe, RollModel& model) {
  constexpr double probe_rad = 1e-3;
  const auto nodes = static_cast<Index>(model.node_rad.size());
  VectorXd now = residual(record, airframe, model);
  double damping = 1e-9;
  for (int iteration = 0; iteration < 20; ++iteration) {
    MatrixXd jacobian(now.size(), nodes);
    for (Index k = 0; k < nodes; ++k) {
      RollModel moved = model;
      moved.node_rad[static_cast<std::size_t>(k)] += probe_rad;
      jacobian.col(k) = (now - residual(record, airframe, moved)) / probe_rad;
    }
    MatrixXd normal = jacobian.transpose() * jacobian;
    normal.diagonal() *= 1.0 + damping;
    const VectorXd step = normal.ldlt().solve(jacobian.transpose() * now);
    RollModel moved = model;
    for (Index k = 0; k < nodes; ++k) {
      moved.node_rad[static_cast<std::size_t>(k)] += step(k);
    }
    const VectorXd then = residual(record, airframe, moved);
    if (then.squaredNorm() > now.squaredNorm()) {
      damping = 10.0 * damping + 1e-9;
    } else {
      model = moved;
      now = then;
    }
    if (step.norm() < 1e-10) {
      return;
    }
  }
}

}  // namespace

GridResult search_by_brute_force(const Record& record, const Airframe& airframe, const NodeTimes& nodes,
                                 const Grid& grid) {
  GridResult result;
  result.errors.alpha_m2 = grid.alpha_m2.values();
  result.errors.beta_m = grid.beta_m.values();
  double least = 0.0;
  for (const double beta_m : result.errors.beta_m) {
    for (const double alpha_m2 : result.errors.alpha_m2) {
      RollModel model{.alpha_m2 = alpha_m2,
                      .beta_m = beta_m,
                      .node_time_s = nodes,
                      .node_rad = std::vector<double>(nodes.size(), 0.0),
                      .initial = measured_starts(record)};
      fit_nodes(record, airframe, model);
      const double error = residual(record, airframe, model).cwiseAbs().mean();
      if (result.errors.mean_abs_angle_error_rad.empty() || error < least) {
        least = error;
        result.model = model;
      }
      result.errors.mean_abs_angle_error_rad.push_back(error);
    }
  }
  return result;
}

}  // namespace fantail::identify::model
