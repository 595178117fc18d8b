// SPDX-License-Identifier: MIT
#include "identify/identification.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "identify/closed_loop/closed_loop.hpp"
#include "identify/model/open_loop.hpp"
#include "identify/result/uncertainty.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

using namespace model;
using namespace result;
using text::Error;
using text::ErrorKind;

void check_record(const Record& record, std::size_t nodes, Start start) {
  const std::size_t unknowns = 2 + nodes + (start == Start::fitted ? 2 * record.segment_begin.size() : std::size_t{0});
  if (record.size() <= unknowns) {
    throw Error{ErrorKind::bad_data,
                fmt::format("window {}: {} for {} unknowns; there must be more samples than unknowns", record.window,
                            text::counted(record.size(), "sample"), unknowns)};
  }
  const auto still = [](const std::vector<double>& values) {
    return std::ranges::all_of(values, [&values](double value) { return value == values.front(); });
  };
  if (still(record.roll_angle_rad) && still(record.roll_rate_rad_s)) {
    throw Error{ErrorKind::bad_data,
                fmt::format("window {}: roll angle and roll rate are constant in all samples, so nothing can be "
                            "identified; even a rocket at rest shows gyro noise",
                            record.window)};
  }
  if (std::ranges::none_of(record.speed_m_s, [](double speed) { return speed > 0.0; })) {
    throw Error{ErrorKind::bad_data,
                fmt::format("window {}: the speed is never above zero, so nothing can be identified", record.window)};
  }
}

// The fit that a number of nodes is judged by, and what the searches share.
struct Fitting {
  const Record& record;
  const Airframe& airframe;
  Options& options;
};

RollModel open_loop_model(const Fitting& q, const NodeTimes& nodes, std::optional<ErrorMap>& errors) {
  const auto& [record, airframe, options] = q;
  if (options.method == Method::grid || options.with_error_map) {
    GridResult found = search_open_loop_grid(record, airframe, nodes, options.start, options.grid);
    errors = std::move(found.errors);
    if (options.method == Method::grid) {
      return std::move(found.model);
    }
  }
  return fit_open_loop(record, airframe, nodes, options.start, options.grid);
}

// Where the servo is fitted, what was found goes into the fitting: all else goes on with it.
RollModel closed_loop_model(const Fitting& q, const NodeTimes& nodes, std::optional<ErrorMap>& errors) {
  const auto& [record, airframe, options] = q;
  closed_loop::Control& control = *options.closed_loop;
  const bool on_grid = options.method == Method::grid || options.with_error_map;
  std::optional<closed_loop::Fit> found;
  if (control.servo_is_fitted || !on_grid) {
    found = closed_loop::fit(record, airframe, control, nodes, options.start, options.grid);
    control = found->control;
  }
  if (!on_grid) {
    return std::move(found->model);
  }
  closed_loop::GridResult searched =
      closed_loop::search_grid(record, airframe, control, nodes, options.start, options.grid);
  errors = std::move(searched.errors);
  if (options.method == Method::grid) {
    return std::move(searched.model);
  }
  if (!found) {
    return closed_loop::fit(record, airframe, control, nodes, options.start, options.grid, searched.least_squares)
        .model;
  }
  closed_loop::Fit further =
      closed_loop::Descent{record, airframe, control, nodes, options.start}.from(searched.least_squares);
  if (further.squares_rad2 < found->squares_rad2) {
    found = std::move(further);
    control = found->control;
  }
  return std::move(found->model);
}

RollModel model_with(const Fitting& q, const NodeTimes& nodes, std::optional<ErrorMap>& errors) {
  check_nodes(q.record, nodes);
  check_record(q.record, nodes.size(), q.options.start);
  return q.options.closed_loop ? closed_loop_model(q, nodes, errors) : open_loop_model(q, nodes, errors);
}

Simulation simulate(const Fitting& q, const RollModel& model) {
  return q.options.closed_loop ? closed_loop::simulate(q.record, q.airframe, *q.options.closed_loop, model)
                               : simulate_open_loop(q.record, q.airframe, model);
}

// As few intervals as come within a tenth of the least error: the published rule, "until there is no significant
// further improvement", with a number. The error need not fall evenly: it may take three intervals before any of them
// helps. A hundredth of a degree is less than any sensor shows, so it is no improvement either.
std::size_t fewest_sufficient(const std::vector<NodeTrial>& trials) {
  constexpr double close_enough = 1.1;
  constexpr double unseen_rad = 0.01 * std::numbers::pi / 180.0;
  const auto error = [](const NodeTrial& trial) { return trial.mean_abs_angle_error_rad; };
  const double least = error(*std::ranges::min_element(trials, {}, error));
  const double limit = std::max(close_enough * least, least + unseen_rad);
  const auto first = std::ranges::find_if(trials, [&](const NodeTrial& trial) { return error(trial) <= limit; });
  return first->intervals;
}

NodeTimes choose_nodes(const Fitting& q, std::vector<NodeTrial>& trials) {
  if (const auto* times = std::get_if<NodeTimes>(&q.options.nodes)) {
    return *times;
  }
  if (const auto* even = std::get_if<EvenNodes>(&q.options.nodes)) {
    return even_nodes(q.record, even->intervals);
  }
  Options quick = q.options;
  quick.with_error_map = false;
  const Fitting trial_fitting{q.record, q.airframe, quick};
  for (std::size_t n = 1; n <= std::get<AutomaticNodes>(q.options.nodes).most; ++n) {
    std::optional<ErrorMap> ignored;
    const RollModel model = model_with(trial_fitting, even_nodes(q.record, n), ignored);
    trials.push_back({.intervals = n,
                      .model = model,
                      .mean_abs_angle_error_rad = simulate(trial_fitting, model).mean_abs_angle_error_rad});
  }
  return even_nodes(q.record, fewest_sufficient(trials));
}

// The axis that a picture of the error has, so that an answer lies on it, and its interval where that is narrow: what
// was searched, or around the answer.
Axis axis_around(double found, const Interval& known, const Axis& searched) {
  const bool narrow = is_identifiable(known);
  const double low = narrow ? std::min(*known.low, found) : found;
  const double high = narrow ? std::max(*known.high, found) : found;
  const std::vector<double> values = searched.values();
  if (low >= values.front() && high <= values.back()) {
    return searched;
  }
  const double first = std::min({low, 0.5 * found, 1.5 * found});
  const double last = std::max({high, 0.5 * found, 1.5 * found});
  const auto cells = static_cast<double>(std::max<std::size_t>(values.size(), 11));
  return {.first = first, .last = last, .step = (last - first) / (cells - 1.0)};
}

bool is_same(const Axis& a, const Axis& b) { return a.first == b.first && a.last == b.last && a.step == b.step; }

void show_the_answer(const Fitting& q, Identification& result) {
  if (!result.error_map || result.method == Method::grid) {
    return;
  }
  const auto& known = result.uncertainty;
  const Grid& searched = q.options.grid;
  const Grid around{
      .alpha_m2 = axis_around(result.model.alpha_m2, known ? known->alpha_profile_m2 : Interval{}, searched.alpha_m2),
      .beta_m = axis_around(result.model.beta_m, known ? known->interval[1] : Interval{}, searched.beta_m)};
  if (is_same(around.alpha_m2, searched.alpha_m2) && is_same(around.beta_m, searched.beta_m)) {
    return;
  }
  const NodeTimes& nodes = result.model.node_time_s;
  const auto& [record, airframe, options] = q;
  result.error_map =
      options.closed_loop
          ? closed_loop::search_grid(record, airframe, *options.closed_loop, nodes, options.start, around).errors
          : search_open_loop_grid(record, airframe, nodes, options.start, around).errors;
}

void remark_on_edges(Identification& result, const Grid& grid) {
  if (result.method != Method::grid) {
    return;
  }
  const auto on_edge = [](double value, const Axis& axis) {
    const std::vector<double> values = axis.values();
    return values.size() > 1 && (value == values.front() || value == values.back());
  };
  if (on_edge(result.model.alpha_m2, grid.alpha_m2) || on_edge(result.model.beta_m, grid.beta_m)) {
    result.on_grid_edge = true;
    result.remarks.emplace_back("The best grid point is on the edge of the grid; a better one may lie outside it.");
  }
}

Uncertainty uncertainty(const Fitting& q, const RollModel& model, const Simulation& simulation) {
  return q.options.closed_loop
             ? closed_loop_uncertainty(q.record, q.airframe, *q.options.closed_loop, model, simulation, q.options.start)
             : open_loop_uncertainty(q.record, q.airframe, model, simulation, q.options.start);
}

// A grid's winner is a rounded answer. Noise is judged around the answer without rounding, and what is stated reaches
// from there to the grid's point.
Uncertainty uncertainty_with_grid(const Fitting& q, const RollModel& on_grid) {
  const auto& [record, airframe, options] = q;
  const NodeTimes& nodes = on_grid.node_time_s;
  Options exactly = options;
  RollModel refined;
  if (options.closed_loop) {
    closed_loop::Fit found =
        closed_loop::fit(record, airframe, *options.closed_loop, nodes, options.start, options.grid, on_grid);
    refined = std::move(found.model);
    exactly.closed_loop = found.control;
  } else {
    refined = fit_open_loop(record, airframe, nodes, options.start, options.grid);
  }
  const Fitting again{record, airframe, exactly};
  Uncertainty result = uncertainty(again, refined, simulate(again, refined));
  const std::vector<double> rounded = on_grid.numbers();
  const std::vector<double> exact = refined.numbers();
  const auto reach_out = [](Interval& interval, double value) {
    interval.low = interval.low ? std::optional{std::min(*interval.low, value)} : std::nullopt;
    interval.high = interval.high ? std::optional{std::max(*interval.high, value)} : std::nullopt;
  };
  for (std::size_t k = 0; k < rounded.size(); ++k) {
    reach_out(result.interval[k], rounded[k]);
    result.standard_deviation[k] = std::hypot(result.standard_deviation[k], rounded[k] - exact[k]);
  }
  reach_out(result.alpha_profile_m2, on_grid.alpha_m2);
  return result;
}

// Chooses between nodes as least squares would, then takes the weight from what lies far off.
void add_robust_fit(const Fitting& q, Identification& result) {
  result.robust = fit_open_loop_robustly(q.record, q.airframe, result.model.node_time_s, q.options.grid);
  result.model = result.robust->model;
  result.simulation = simulate(q, result.model);
  if (q.options.with_uncertainty) {
    result.uncertainty =
        open_loop_uncertainty(result.robust->pseudo_record, q.airframe, result.model, result.simulation, Start::fitted);
  }
}

}  // namespace

Identification identify(const Record& record, const Airframe& airframe, const Options& options) {
  Options own = options;
  const Fitting fitting{record, airframe, own};
  Identification result;
  result.method = options.method;
  result.loop = options.closed_loop ? Loop::closed : Loop::open;
  result.samples = record.size();
  result.seconds = record.time_s.back() - record.time_s.front();
  const NodeTimes nodes = choose_nodes(fitting, result.node_trials);
  result.model = model_with(fitting, nodes, result.error_map);
  result.simulation = simulate(fitting, result.model);
  if (own.closed_loop && own.closed_loop->servo_is_fitted) {
    result.servo = Servo{.lag_s = own.closed_loop->servo_lag_s, .play_rad = own.closed_loop->servo_play_rad};
  }
  remark_on_edges(result, options.grid);
  if (options.loss == Loss::huber) {
    add_robust_fit(fitting, result);
  } else if (options.with_uncertainty) {
    result.uncertainty = options.method == Method::grid ? uncertainty_with_grid(fitting, result.model)
                                                        : uncertainty(fitting, result.model, result.simulation);
  }
  show_the_answer(fitting, result);
  return result;
}

}  // namespace fantail::identify
