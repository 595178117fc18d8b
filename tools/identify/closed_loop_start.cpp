// SPDX-License-Identifier: MIT
#include "identify/closed_loop_start.hpp"

#include "identify/alpha_fit.hpp"
#include "identify/closed_loop_trials.hpp"
#include "identify/open_loop.hpp"

namespace fantail::identify {

FirstGuess::FirstGuess(const Record& record, const Airframe& airframe, const NodeTimes& node_time_s, Start start)
    : record_{record}, node_time_s_{node_time_s}, start_{start} {
  if (!record.canard_rad.empty()) {
    basis_.emplace(record, airframe, node_time_s, start);
  }
}

Eigen::VectorXd FirstGuess::at(double alpha_m2, double beta_m) const {
  if (basis_) {
    return unknown_of(AlphaFit{*basis_, alpha_m2}.model(beta_m, node_time_s_), start_);
  }
  return unknown_of({.alpha_m2 = alpha_m2,
                     .beta_m = beta_m,
                     .node_time_s = node_time_s_,
                     .node_rad = std::vector<double>(node_time_s_.size(), 0.0),
                     .initial = measured_starts(record_)},
                    start_);
}

}  // namespace fantail::identify
