// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "identify/closed_loop/trials.hpp"
#include "identify/model/alpha_fit.hpp"

namespace fantail::identify::closed_loop {

/// Flies `model` through the record with the flight controller in the loop: what the rocket should have done. The
/// canard angles of the result are the commands. Throws as make_course() does, and so does all that follows.
[[nodiscard]] model::Simulation simulate(const model::Record& record, const model::Airframe& airframe,
                                         const Control& control, const model::RollModel& model);

/// How much the angle moves with the numbers of the model and with the states at the begin of the segments, carried
/// along through plant, servo and controller: while a command is at its limit it does not depend on anything.
[[nodiscard]] model::Sensitivities sensitivities(const model::Record& record, const model::Airframe& airframe,
                                                 const Control& control, const model::RollModel& model);

/// What besides alpha and beta is looked for: nodes and, with Start::fitted, angle and rate at the begin of each
/// segment.
[[nodiscard]] Eigen::VectorXd unknown_of(const model::RollModel& model, model::Start start);

/// The model with these; without Start::fitted its segments begin as measured.
[[nodiscard]] model::RollModel model_of(const model::Record& record, const model::NodeTimes& node_time_s,
                                        model::Start start, double alpha_m2, double beta_m,
                                        const Eigen::VectorXd& unknown);

/// What to begin a search with, at a given alpha and beta: the unknowns of the open loop, which take one linear solve.
/// A log without encoders gives none: then no disturbance, and segments as measured.
class FirstGuess {
 public:
  FirstGuess(const model::Record& record, const model::Airframe& airframe, const model::NodeTimes& node_time_s,
             model::Start start);

  [[nodiscard]] Eigen::VectorXd at(double alpha_m2, double beta_m) const;

 private:
  const model::Record& record_;
  model::NodeTimes node_time_s_;
  model::Start start_;
  std::optional<model::ResponseBasis> basis_{};
};

/// The controller counts in single precision: a tenth of a microradian. Errors below it are as good as none.
inline constexpr double single_precision_rad2 = 1e-14;

struct GridResult {
  model::RollModel model;          ///< of the least mean absolute angle error: the published rule
  model::RollModel least_squares;  ///< of the least sum of squares: where a continuous fit may go on
  model::ErrorMap errors;
};

/// Eq 22 with the controller in the loop: nodes by least squares for every alpha and beta of the grid.
[[nodiscard]] GridResult search_grid(const model::Record& record, const model::Airframe& airframe,
                                     const Control& control, const model::NodeTimes& node_time_s, model::Start start,
                                     const model::Grid& grid);

struct Fit {
  model::RollModel model;
  double squares_rad2;  ///< sum of squared angle errors
  Control control;      ///< with the servo that was found, where it is fitted
};

enum class Alpha : std::uint8_t { fitted, held };

/// Least squares for all numbers of a model at once, from one place to the nearest minimum. Where the servo is fitted,
/// its lag is one of them, and its play, where that begins above zero.
class Descent {
 public:
  /// `record` must live as long.
  Descent(const model::Record& record, const model::Airframe& airframe, const Control& control,
          const model::NodeTimes& node_time_s, model::Start start);
  Descent(const Descent&) = delete;
  Descent& operator=(const Descent&) = delete;

  [[nodiscard]] Fit from(const model::RollModel& begin, Alpha alpha = Alpha::fitted);

  /// The sum of squared angle errors of a model as it stands.
  [[nodiscard]] double squares_rad2(const model::RollModel& model);

 private:
  [[nodiscard]] model::NormalEquations evaluate(const Eigen::VectorXd& unknown, Alpha alpha);

  const model::Record& record_;
  Control control_;
  model::NodeTimes node_time_s_;
  model::Start start_;
  model::AlphaRange alpha_range_;
  Course course_;
  LaneTrials<1> trials_;
  Plant plant_{};
};

/// The model of least squares, alpha and beta not bound to a grid. With the controller in the loop the sum of squares
/// has many local minima, because a command at its limit hides what the rest of the model does: so the descent begins
/// at twelve places spread over `range`, and at the best cell of a grid. The servo is fitted last, without play and
/// with it; play is kept where it takes more off the sum than chance would. `grid_best` is that cell if a grid has been
/// searched already; else a coarse one is. Never worse than where it began.
[[nodiscard]] Fit fit(const model::Record& record, const model::Airframe& airframe, const Control& control,
                      const model::NodeTimes& node_time_s, model::Start start, const model::Grid& range,
                      const std::optional<model::RollModel>& grid_best = std::nullopt);

}  // namespace fantail::identify::closed_loop
