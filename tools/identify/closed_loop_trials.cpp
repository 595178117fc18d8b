// SPDX-License-Identifier: MIT
#include "identify/closed_loop_trials.hpp"

#include "identify/open_loop.hpp"

namespace fantail::identify {

Eigen::VectorXd unknown_of(const Model& model, Start start) {
  const std::size_t initial = start == Start::fitted ? 2 * model.initial.size() : 0;
  Eigen::VectorXd unknown{static_cast<Eigen::Index>(model.node_rad.size() + initial)};
  Eigen::Index i = 0;
  for (const double node_rad : model.node_rad) {
    unknown(i++) = node_rad;
  }
  if (start == Start::fitted) {
    for (const InitialState& state : model.initial) {
      unknown(i++) = state.angle_rad;
      unknown(i++) = state.rate_rad_s;
    }
  }
  return unknown;
}

Model model_of(const Record& record, const NodeTimes& node_time_s, Start start, double alpha_m2, double beta_m,
               const Eigen::VectorXd& unknown) {
  Model model{.alpha_m2 = alpha_m2,
              .beta_m = beta_m,
              .node_time_s = node_time_s,
              .node_rad = {},
              .initial = measured_starts(record)};
  Eigen::Index i = 0;
  for (std::size_t k = 0; k < node_time_s.size(); ++k) {
    model.node_rad.push_back(unknown(i++));
  }
  if (start == Start::fitted) {
    for (InitialState& state : model.initial) {
      state.angle_rad = unknown(i++);
      state.rate_rad_s = unknown(i++);
    }
  }
  return model;
}

}  // namespace fantail::identify
