// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "identify/closed_loop_trials.hpp"
#include "identify/identification.hpp"

namespace fantail::identify {

struct ClosedLoopFit {
  Model model;
  double squares_rad2;  ///< sum of squared angle errors
};

enum class Alpha : std::uint8_t { fitted, held };

/// Least squares for all numbers of a model at once, from one place to the nearest minimum.
class ClosedLoopDescent {
 public:
  /// `record` must live as long.
  ClosedLoopDescent(const Record& record, const Airframe& airframe, const ClosedLoop& loop,
                    const NodeTimes& node_time_s, Start start);
  ClosedLoopDescent(const ClosedLoopDescent&) = delete;
  ClosedLoopDescent& operator=(const ClosedLoopDescent&) = delete;

  [[nodiscard]] ClosedLoopFit from(const Model& begin, Alpha alpha = Alpha::fitted);

  /// The sum of squared angle errors of a model as it stands.
  [[nodiscard]] double squares_rad2(const Model& model);

 private:
  [[nodiscard]] NormalEquations try_out(const Eigen::VectorXd& unknown, Alpha alpha);

  const Record& record_;
  NodeTimes node_time_s_;
  Start start_;
  Course course_;
  LaneTrials<1> trials_;
  Transitions transitions_{};
};

/// The model of least squares, alpha and beta not bound to a grid. With the controller in the loop the sum of squares
/// has many local minima, because a command at its limit hides what the rest of the model does: so the descent begins
/// at twelve places spread over `range`, and at the best cell of a grid. `grid_best` is that cell if a grid has been
/// searched already; else a coarse one is. Never worse than where it began.
[[nodiscard]] ClosedLoopFit fit_closed_loop(const Record& record, const Airframe& airframe, const ClosedLoop& loop,
                                            const NodeTimes& node_time_s, Start start, const Grid& range,
                                            const std::optional<Model>& grid_best = std::nullopt);

}  // namespace fantail::identify
