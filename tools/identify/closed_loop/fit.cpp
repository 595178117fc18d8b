// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "identify/closed_loop/closed_loop.hpp"

namespace fantail::identify::closed_loop {
namespace {

using namespace model;

constexpr std::size_t alpha_starts = 6;
constexpr std::array<double, 2> beta_starts{0.25, 0.75};  // shares of the range

// Every share of the way from first to last is as near to one of these as to any.
double share(std::size_t i, std::size_t count) { return (static_cast<double>(i) + 0.5) / static_cast<double>(count); }

// What alpha does goes with its logarithm: from 1 to 2 the motion changes as much as from 20 to 40.
double alpha_start_m2(const Axis& range, const AlphaRange& allowed, std::size_t i) {
  const double first = std::clamp(range.first, allowed.lowest_m2, allowed.highest_m2);
  const double last = std::clamp(range.last, first, allowed.highest_m2);
  return first * std::pow(last / first, share(i, alpha_starts));
}

constexpr double shortest_fitted_lag_s = 1e-4;
constexpr double longest_fitted_lag_s = 0.5;
constexpr std::array play_starts_rad{0.1 * std::numbers::pi / 180.0, 0.3 * std::numbers::pi / 180.0};

Fit with_servo(const Record& record, const Airframe& airframe, const Control& control, const RollModel& begin,
               Start start) {
  Control from = control;
  from.servo_play_rad = 0.0;
  Fit best = Descent{record, airframe, from, begin.node_time_s, start}.from(begin);
  const double without_play_rad2 = best.squares_rad2;
  for (const double play_rad : play_starts_rad) {
    from.servo_lag_s = best.control.servo_lag_s;
    from.servo_play_rad = play_rad;
    Fit found = Descent{record, airframe, from, begin.node_time_s, start}.from(best.model);
    // Chance takes off as much as one of the samples' squares.
    constexpr double beyond_chance = 4.0;
    const double chance_rad2 = beyond_chance * without_play_rad2 / static_cast<double>(record.size());
    if (found.squares_rad2 < std::min(best.squares_rad2, without_play_rad2 - chance_rad2)) {
      best = std::move(found);
    }
  }
  return best;
}

Axis coarse(const Axis& axis, double steps) {
  if (!(axis.last > axis.first)) {
    return axis;
  }
  return {.first = axis.first, .last = axis.last, .step = std::max(axis.step, (axis.last - axis.first) / steps)};
}

}  // namespace

Eigen::VectorXd unknown_of(const RollModel& model, Start start) {
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

RollModel model_of(const Record& record, const NodeTimes& node_time_s, Start start, double alpha_m2, double beta_m,
                   const Eigen::VectorXd& unknown) {
  RollModel model{.alpha_m2 = alpha_m2,
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

Descent::Descent(const Record& record, const Airframe& airframe, const Control& control, const NodeTimes& node_time_s,
                 Start start)
    : record_{record},
      control_{control},
      node_time_s_{node_time_s},
      start_{start},
      alpha_range_{alpha_range(airframe)},
      course_{make_course(record, airframe, control, node_time_s)},
      trials_{course_, {.initial = start == Start::fitted, .model = true, .servo = control.servo_is_fitted}} {}

// The unknowns here: log alpha, which cannot leave the positive numbers, then beta, where the servo is fitted the
// logarithm of its lag and half of its play, and the others.
NormalEquations Descent::evaluate(const Eigen::VectorXd& unknown, Alpha alpha) {
  const double alpha_m2 = std::exp(unknown(0));
  if (!alpha_range_.contains(alpha_m2)) {
    return {.squares = std::numeric_limits<double>::infinity()};
  }
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(unknown.size());
  scale(0) = alpha == Alpha::held ? 0.0 : alpha_m2;
  if (control_.servo_is_fitted) {
    const double lag_s = std::exp(unknown(2));
    if (lag_s < shortest_fitted_lag_s || lag_s > longest_fitted_lag_s || unknown(3) < 0.0) {
      return {.squares = std::numeric_limits<double>::infinity()};
    }
    course_.set_servo(lag_s, 2.0 * unknown(3));
    scale(2) = lag_s;
    scale(3) = control_.servo_play_rad > 0.0 ? 1.0 : 0.0;
  }
  const Eigen::Index before_nodes = control_.servo_is_fitted ? 4 : 2;
  plant_.set_alpha(course_, alpha_m2, Slopes::by_alpha);
  trials_.set(0, unknown(1), unknown.tail(unknown.size() - before_nodes));
  trials_.fly_with_derivatives(plant_);
  NormalEquations result = trials_.equations(0);
  result.normal = scale.asDiagonal() * result.normal * scale.asDiagonal();
  result.gradient = scale.asDiagonal() * result.gradient;
  return result;
}

Fit Descent::from(const RollModel& begin, Alpha alpha) {
  const Eigen::VectorXd rest = unknown_of(begin, start_);
  const Eigen::Index before_nodes = control_.servo_is_fitted ? 4 : 2;
  Eigen::VectorXd unknown{rest.size() + before_nodes};
  unknown(0) = std::log(std::clamp(begin.alpha_m2, alpha_range_.lowest_m2, alpha_range_.highest_m2));
  unknown(1) = begin.beta_m;
  if (control_.servo_is_fitted) {
    unknown(2) = std::log(std::clamp(control_.servo_lag_s, 2.0 * shortest_fitted_lag_s, 0.5 * longest_fitted_lag_s));
    unknown(3) = 0.5 * control_.servo_play_rad;
  }
  unknown.tail(rest.size()) = rest;
  LevenbergMarquardt search{unknown,
                            {.first_damping = 1e-3,
                             .relative_gain = 1e-9,
                             .absolute_gain = static_cast<double>(record_.size()) * single_precision_rad2,
                             .most_trials = 60}};
  while (!search.finished()) {
    search.tell(evaluate(search.trial(), alpha));
  }
  const Eigen::VectorXd& best = search.best();
  Fit found{.model = model_of(record_, node_time_s_, start_, alpha == Alpha::held ? begin.alpha_m2 : std::exp(best(0)),
                              best(1), best.tail(rest.size())),
            .squares_rad2 = search.squares(),
            .control = control_};
  if (control_.servo_is_fitted) {
    found.control.servo_lag_s = std::exp(best(2));
    found.control.servo_play_rad = 2.0 * best(3);
  }
  return found;
}

double Descent::squares_rad2(const RollModel& model) {
  plant_.set_alpha(course_, model.alpha_m2, Slopes::none);
  trials_.set(0, model.beta_m, unknown_of(model, start_));
  trials_.fly(plant_);
  return trials_.errors().squares(0);
}

Fit fit(const Record& record, const Airframe& airframe, const Control& control, const NodeTimes& node_time_s,
        Start start, const Grid& range, const std::optional<RollModel>& grid_best) {
  Control held = control;
  held.servo_is_fitted = false;
  const auto searched = [&] {
    const Grid grid{.alpha_m2 = coarse(range.alpha_m2, 12.0), .beta_m = coarse(range.beta_m, 4.0)};
    return search_grid(record, airframe, held, node_time_s, start, grid).least_squares;
  };
  Descent descent{record, airframe, held, node_time_s, start};
  Fit best = descent.from(grid_best ? *grid_best : searched());
  const FirstGuess guess{record, airframe, node_time_s, start};
  for (std::size_t i = 0; i < alpha_starts; ++i) {
    for (const double beta_share : beta_starts) {
      const double alpha_m2 = alpha_start_m2(range.alpha_m2, alpha_range(airframe), i);
      const double beta_m = range.beta_m.first + beta_share * (range.beta_m.last - range.beta_m.first);
      Fit found = descent.from(model_of(record, node_time_s, start, alpha_m2, beta_m, guess.at(alpha_m2, beta_m)));
      if (found.squares_rad2 < best.squares_rad2) {
        best = std::move(found);
      }
    }
  }
  // The steepest way down may have been longer than one descent has steps.
  Fit further = descent.from(best.model);
  if (further.squares_rad2 < best.squares_rad2) {
    best = std::move(further);
  }
  return control.servo_is_fitted ? with_servo(record, airframe, control, best.model, start) : best;
}

}  // namespace fantail::identify::closed_loop
