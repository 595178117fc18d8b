// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "fly/gravity_turn.hpp"
#include "predict/decision.hpp"
#include "predict/sentences.hpp"
#include "text/apart.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using text::brief;
using text::degrees;
using text::fixed;

// So shortly before apogee the air is slow and turns nothing much: a guide of five degrees, which is usual, is no
// reason for a no go.
constexpr double shortly_s = 1.0;

// Nearer to the tilt limit, a little more wind, or the error of the avionics' own tilt, ends control.
constexpr double near_tilt_limit_rad = text::radians(5.0);

double tilt_limit_rad(const Prediction& p) { return static_cast<double>(p.flown.plan.run.tilt_limit.radians()); }

/// After lift-off, of the run in which it ends last.
std::optional<double> end_of_control_s(const Prediction& p) {
  std::optional<double> last_s;
  for (const Run& run : p.runs) {
    for (std::size_t i = run.reference_rad.size(); i > 0; --i) {
      if (run.reference_rad[i - 1]) {
        last_s = std::max(last_s.value_or(0.0), track_step_s * static_cast<double>(i - 1));
        break;
      }
    }
  }
  return last_s;
}

/// When it has to be, and when it is.
struct Passing {
  double not_before_s = 0.0;
  std::optional<double> at_s{};

  [[nodiscard]] bool too_early() const { return at_s && *at_s < not_before_s; }
};

Passing passing(const sim::Scenario& scenario, double end_of_control_s) {
  const fly::GravityTurn turn = fly::gravity_turn(scenario);
  return {.not_before_s = std::min(end_of_control_s, turn.apogee_s - shortly_s), .at_s = turn.tilt_limit_s};
}

bool asks_a_point_mass(const Prediction& p) {
  return p.flown.motion != sim::FlightMotion::six_dof && p.flown.guide.tilt_rad >= fly::slight_tilt_rad;
}

/// Of the runs that do not come to the limit, or of a point mass in their place; empty: not known.
std::optional<double> largest_tilt_rad(const Prediction& p) {
  std::optional<double> largest_rad;
  for (const Run& run : p.runs) {
    if (run.largest_tilt_rad && !run.ended_by_tilt && !run.allowed_tilt_end_s) {
      largest_rad = std::max(largest_rad.value_or(0.0), *run.largest_tilt_rad);
    }
  }
  const auto end_s = end_of_control_s(p);
  if (!asks_a_point_mass(p) || !end_s) {
    return largest_rad;
  }
  const double not_before_s = passing(p.flown, *end_s).not_before_s;
  const std::vector<double> tilts_rad = fly::gravity_turn(p.flown).tilts_rad;
  for (std::size_t i = 0; i < tilts_rad.size() && fly::gravity_turn_step_s * static_cast<double>(i) < not_before_s;
       ++i) {
    largest_rad = std::max(largest_rad.value_or(0.0), tilts_rad[i]);
  }
  return largest_rad;
}

}  // namespace

std::optional<Criterion> tilt_limit(const Prediction& p) {
  const auto end_s = end_of_control_s(p);
  if (!asks_a_point_mass(p) || !end_s) {
    return std::nullopt;
  }
  const Passing pass = passing(p.flown, *end_s);
  const std::string limit = brief(degrees(tilt_limit_rad(p)), 1);
  Criterion c{.key = "tilt_limit",
              .label = fmt::format("Tilt limit of {} degrees under control, point mass", limit),
              .found = pass.at_s
                           ? fmt::format("passed {} s after lift-off", text::apart(*pass.at_s, pass.not_before_s, 2))
                           : "not passed",
              .required = fmt::format("not before {} s", fixed(pass.not_before_s, 2)),
              .judgement = pass.too_early() ? Judgement::not_met : Judgement::met};
  if (pass.too_early()) {
    c.clause = fmt::format(
        "with a guide that leans by {} degrees, a point mass passes the plan's tilt limit of {} degrees from {} {} s "
        "after lift-off. That ends control. The simulated rocket stays on the line of its guide and does not show "
        "this",
        brief(degrees(p.flown.guide.tilt_rad), 1), limit, flight::tilt_origin(p.flown.plan), fixed(*pass.at_s, 1));
  }
  return c;
}

std::optional<Criterion> beyond_guide(const Prediction& p) {
  std::size_t count = 0;
  double longest_s = 0.0;
  for (const Run& run : p.runs) {
    count += run.begun_on_guide_s ? 1 : 0;
    longest_s = std::max(longest_s, run.begun_on_guide_s.value_or(0.0));
  }
  if (count == 0) {
    return std::nullopt;
  }
  const std::string these =
      count == p.runs.size() ? "in all runs" : fmt::format("in {} of {}", count, runs(p.runs.size()));
  return Criterion{.key = "guide",
                   .label = "Control begins beyond the launch guide",
                   .found = "inside it " + these,
                   .required = "in every run",
                   .judgement = Judgement::not_met,
                   .clause = fmt::format("{} control begins inside the launch guide, up to {} s before the rocket "
                                         "leaves it. Moving canards can jam it there: check guide.length_m in the plan",
                                         these, fixed(longest_s, 3))};
}

std::string tilt_caution(const Prediction& p) {
  const std::optional<double> tilt_rad = largest_tilt_rad(p);
  const double limit_rad = tilt_limit_rad(p);
  if (!tilt_rad || *tilt_rad < limit_rad - near_tilt_limit_rad) {
    return {};
  }
  return fmt::format("{} tilts by up to {} degrees from {} under control, and the plan's tilt limit is {} degrees",
                     asks_a_point_mass(p) ? "with this guide, a point mass" : "the rocket",
                     text::apart(degrees(*tilt_rad), degrees(limit_rad), 1), flight::tilt_origin(p.flown.plan),
                     brief(degrees(limit_rad), 1));
}

std::string advice_on_tilt(const Prediction& p) {
  sim::Scenario scenario = p.flown;
  for (int half_degrees = static_cast<int>(std::floor(2.0 * degrees(p.flown.guide.tilt_rad)));
       text::radians(0.5 * half_degrees) >= fly::slight_tilt_rad; --half_degrees) {
    const double tilt_deg = 0.5 * half_degrees;
    scenario.guide.tilt_rad = text::radians(tilt_deg);
    if (!passing(scenario, end_of_control_s(p).value_or(0.0)).too_early()) {
      return fmt::format("With a guide that leans by {} degrees, a point mass would not pass the tilt limit too early.",
                         brief(tilt_deg, 1));
    }
  }
  return {};
}

}  // namespace fantail::predict
