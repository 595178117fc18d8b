// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "identify/identification.hpp"
#include "identify/response_basis.hpp"

namespace fantail::identify {

/// Nodes (and initial states) to begin a closed-loop search with, at a given alpha and beta: those of the open loop,
/// which take one linear solve. A log without encoders gives none: then no disturbance, and segments as measured.
class FirstGuess {
 public:
  FirstGuess(const Record& record, const Airframe& airframe, const NodeTimes& node_time_s, Start start);

  [[nodiscard]] Eigen::VectorXd at(double alpha_m2, double beta_m) const;

 private:
  const Record& record_;
  NodeTimes node_time_s_;
  Start start_;
  std::optional<ResponseBasis> basis_{};
};

}  // namespace fantail::identify
