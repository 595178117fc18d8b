// SPDX-License-Identifier: MIT
#include "identify/doubts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "identify/model/least_squares.hpp"
#include "identify/model/open_loop.hpp"
#include "identify/result/residual.hpp"
#include "identify/result/uncertainty.hpp"
#include "identify/result/words.hpp"
#include "logs/roll_log.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

using namespace model;
using namespace result;

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

// The published rocket has a beta of 5 to 15 m; one beyond a tenth or ten times that is a matter for a word only when
// the canards' own angles speak for it.
std::optional<std::string> wrong_unit(const DoubtCase& c) {
  constexpr double most_radians = 0.7;  // 40 deg: no canard turns farther
  const double beta_m = c.found.model.beta_m;
  const Axis usual = published_grid(c.airframe).beta_m;
  const double canard_deg = text::degrees(logs::largest(c.record.canard_rad));
  if (canard_deg <= most_radians && beta_m > 10.0 * usual.last) {
    return fmt::format(
        "beta is {} m and no canard angle exceeds {} deg: the canard column seems to be in radians. If it is, state "
        "that (--columns rad, or the unit of that column); beta would then be about {} m.",
        constant_text(beta_m), text::brief(canard_deg, 2), constant_text(beta_m / degrees_per_radian));
  }
  if (canard_deg > 90.0 && beta_m > 0.0 && beta_m < 0.1 * usual.first) {
    return fmt::format(
        "beta is {} m and the canards would reach {} deg: the canard column seems to be in degrees but is read as "
        "radians. If so, state that (--columns deg, or the unit of that column); beta would then be about {} m.",
        constant_text(beta_m), text::brief(canard_deg, 0), constant_text(beta_m * degrees_per_radian));
  }
  return {};
}

// What a model with fewer unknowns knows better it should also know right: of a right one, the differences of the
// estimates have the differences of the variances (Hausman 1978).
std::optional<std::string> nodes(const DoubtCase& c) {
  const RollModel& found = c.found.model;
  const NodeTimes more = twice_as_many(c.record, found.node_time_s);
  if (!has_room_for(c.record, more)) {
    return {};
  }
  const RollModel model = fit_open_loop(c.record, c.airframe, more, c.start, published_grid(c.airframe));
  const Uncertainty known =
      open_loop_uncertainty(c.record, c.airframe, model, simulate_open_loop(c.record, c.airframe, model), c.start);
  const auto differs = [&](std::size_t k) {
    const double scale = known.interval[k].high.value() - known.interval[k].low.value();
    const double reach = 0.5 * scale / known.standard_deviation[k];
    const double variance = known.standard_deviation[k] * known.standard_deviation[k];
    const double base = c.found.uncertainty->standard_deviation[k];
    const double spread = std::sqrt(std::max(variance - base * base, 0.1 * variance));
    return std::abs(model.numbers()[k] - found.numbers()[k]) > one_of_hundred * reach * spread;
  };
  if (!matters(c, model) || (!differs(0) && !differs(1))) {
    return {};
  }
  return fmt::format(
      "With more nodes of the disturbance ({} instead of {}) the fit gives {}. Either there are too few nodes, or "
      "something else changes within the window. Try more nodes, as in --nodes even:{}.",
      more.size(), found.node_time_s.size(), change(found, model), more.size() - 1);
}

// Whatever is beyond chance is said, beside the verdict that it qualifies.
std::optional<std::string> unexplained(const DoubtCase& c) {
  constexpr double worth_a_doubt = 0.2;
  constexpr double negligible = 0.01;
  const auto& tests = c.found.residual_tests;
  const bool with_canards = tests && std::abs(tests->canard_correlation) > tests->canard_chance;
  if (!tests || (std::abs(tests->own_correlation) <= tests->chance && !with_canards)) {
    return {};
  }
  const double share = share_left(c.record, c.found.simulation);
  const std::string reaches = fmt::format(
      "The residual of the roll rate, {} % of the motion, is not white noise. Its correlation reaches {} with itself "
      "(chance: up to {}) and {} with the canards (up to {}).",
      text::brief(100.0 * share, 2), text::fixed(tests->own_correlation, 2), text::fixed(tests->chance, 2),
      text::fixed(tests->canard_correlation, 2), text::fixed(tests->canard_chance, 2));
  if (c.found.loop == Loop::closed) {
    return reaches + (with_canards
                          ? " So the model is incomplete, and alpha and beta may lie outside their intervals. "
                            "Possible causes: a delay of the servos, noise that moves the canards to their limit, a "
                            "wrong speed, another plan. Compare with --loop open, which needs no model of the servos."
                          : " A law that reacts to noise or gusts causes this, and the intervals include it. An "
                            "error of the model would cause it, too. Compare with --loop open.");
  }
  if (share < negligible || std::abs(tests->own_correlation) < worth_a_doubt) {
    return reaches + (c.start == Start::fitted
                          ? " So it contains small errors of the model, which the intervals do not include."
                          : " So it contains small errors. Errors of the measured first angle and rate are included "
                            "in the intervals, and --fit-initial fits them. Errors of the model are not included.");
  }
  return reaches +
         " Neither a lag nor more nodes explain it, so there is another cause. Examples: a wrong speed or density in "
         "part of the window, or canards whose torque is not proportional to their angle.";
}

// Only where it was tried and tells both numbers better; Huber's loss knows no fitted lag.
std::string advice_on_loss(const DoubtCase& c) {
  if (!c.record.canard_rate_rad_s.empty()) {
    return {};
  }
  const RollModel& found = c.found.model;
  const RobustFit robust = fit_open_loop_robustly(c.record, c.airframe, found.node_time_s, published_grid(c.airframe));
  const Uncertainty known =
      open_loop_uncertainty(robust.pseudo_record, c.airframe, robust.model,
                            simulate_open_loop(c.record, c.airframe, robust.model), Start::fitted);
  const std::vector<double>& before = c.found.uncertainty->standard_deviation;
  const std::vector<double>& after = known.standard_deviation;
  if (!robust.settled || after[0] >= before[0] || after[1] >= before[1]) {
    return {};
  }
  const Identification other{.model = robust.model, .uncertainty = known};
  return fmt::format(
      " Or use {}--loss huber, which reduces their influence: it gives alpha {} m2 instead of {}, beta {} m instead "
      "of {} (\u00b1: standard deviation).",
      c.found.method == Method::grid ? "--method continuous " : "", with_deviation(other, 0),
      with_deviation(c.found, 0), with_deviation(other, 1), with_deviation(c.found, 1));
}

// A hundredth of Gauss' samples carries a twelfth of the squares.
std::optional<std::string> outliers(const DoubtCase& c) {
  constexpr double most = 0.5;
  std::vector<double> squares;
  double all = 0.0;
  for (std::size_t i = 0; i < c.record.size(); ++i) {
    squares.push_back(std::pow(c.record.roll_angle_rad[i] - c.found.simulation.roll_angle_rad[i], 2));
    all += squares.back();
  }
  std::ranges::sort(squares, std::greater{});
  const std::size_t few = (squares.size() + 99) / 100;
  double of_few = 0.0;
  for (std::size_t i = 0; i < few; ++i) {
    of_few += squares[i];
  }
  if (of_few <= most * all) {
    return {};
  }
  return fmt::format(
      "{} of the {} samples make {} % of the squared angle error: they look like outliers, and least squares follows "
      "them. Look at the residual in the report. Take them out of the log if they are not motion of the rocket.{}",
      few, squares.size(), text::fixed(100.0 * of_few / all, 0), advice_on_loss(c));
}

bool can_be_judged(const DoubtCase& c) {
  const auto& u = c.found.uncertainty;
  return u && *u->interval[1].low > 0.0;
}

}  // namespace

std::vector<std::string> doubts(const Record& record, const Airframe& airframe, Start start,
                                const Identification& found) {
  const DoubtCase c{record, airframe, start, found};
  std::vector<std::string> all;
  if (found.loop == Loop::closed) {
    if (auto lacks = unexplained(c)) {
      all.push_back(std::move(*lacks));
    }
    return all;
  }
  if (!can_be_judged(c)) {
    // A model that a far too late column has spoilt tells nothing; misfit() has seen that it does not fit.
    const auto late = !found.remarks.empty() ? long_lag_doubt(c) : std::nullopt;
    if (late) {
      all.push_back(*late);
    }
    // Outliers widen the intervals until nothing is left to judge: then most of all they must be named.
    if (const auto few = found.uncertainty ? outliers(c) : std::nullopt) {
      all.push_back(*few);
    }
    return all;
  }
  const auto add = [&all](const std::optional<std::string>& sentence) {
    if (sentence) {
      all.push_back(*sentence);
    }
    return sentence.has_value();
  };
  add(wrong_unit(c));
  add(outliers(c));
  // Everything else would compare with a point that another grid would not give.
  if (found.on_grid_edge) {
    return all;
  }
  if ((record.canard_rate_rad_s.empty() && add(lag_doubt(c))) || add(nodes(c))) {
    return all;
  }
  // misfit() has said it already where the residual is almost all motion.
  if (!misfit(record, found)) {
    add(unexplained(c));
  }
  return all;
}

}  // namespace fantail::identify
