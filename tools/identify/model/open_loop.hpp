// SPDX-License-Identifier: MIT
#pragma once

#include "identify/model/roll_model.hpp"

namespace fantail::identify::model {

/// Roll angle and rate of a model whose canards move as the encoders measured (Eq 9), and its errors. Written as the
/// equations stand, a step a sample, and so also what tests hold the fast search against.
[[nodiscard]] Simulation simulate_open_loop(const Record& record, const Airframe& airframe, const RollModel& model);

struct GridResult {
  RollModel model;
  ErrorMap errors;
};

/// Eq 22: nodes by least squares for every alpha and beta of the grid; the winner has the least mean absolute angle
/// error, of equal ones the first.
[[nodiscard]] GridResult search_open_loop_grid(const Record& record, const Airframe& airframe, const NodeTimes& nodes,
                                               Start start, const Grid& grid);

/// The same model by least squares alone, without a grid: for each alpha everything else is linear, so only alpha is
/// searched, within alpha_range(). Where the canards moved no more than the nodes can explain, beta is the middle of
/// `grid`, and the uncertainty says so.
[[nodiscard]] RollModel fit_open_loop(const Record& record, const Airframe& airframe, const NodeTimes& nodes,
                                      Start start, const Grid& grid);

/// The same with an alpha and a beta (not zero) that are known: only the disturbance, and starts that are to be fitted,
/// are found by least squares.
[[nodiscard]] RollModel fit_open_loop_with(double alpha_m2, double beta_m, const Record& record,
                                           const Airframe& airframe, const NodeTimes& nodes, Start start);

/// Of the open loop's angle. Exact but for alpha, which takes a central difference good to about 1e-8.
[[nodiscard]] Sensitivities open_loop_sensitivities(const Record& record, const Airframe& airframe,
                                                    const RollModel& model);

}  // namespace fantail::identify::model
