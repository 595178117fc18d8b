// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/core.h>

#include "faults/campaign.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::faults {
namespace {

/// Of two flights of a cell, the one to look at.
bool is_worse(const Run& a, const Run& b) {
  if (a.outcome.has_value() != b.outcome.has_value()) {
    return !a.outcome;
  }
  const auto measure = [](const Run& run) {
    const bool is_over = run.outcome == Outcome::over || run.outcome == Outcome::no_control;
    return is_over ? std::max(run.trim_after_s, run.stands_after_s) : run.apart_deg;
  };
  return measure(a) > measure(b);
}

std::string figure_of(const Run& run) {
  if (!run.outcome) {
    return run.what;
  }
  switch (*run.outcome) {
    case Outcome::not_armed: return "not armed";
    case Outcome::no_control: return "no control";
    case Outcome::over:
      return fmt::format("at trim after {:.3f} s, canards after {:.3f} s", run.trim_after_s, run.stands_after_s);
    case Outcome::anything: return fmt::format("{:.1f} deg apart, of which nothing is asked", run.apart_deg);
    case Outcome::holds:
    case Outcome::recovers:
    case Outcome::goes_on: break;
  }
  return fmt::format("{:.1f} deg apart", run.apart_deg);
}

}  // namespace

const char* name(Colour colour) {
  switch (colour) {
    case Colour::green: return "green";
    case Colour::red: return "red";
    case Colour::known_limit: return "known limit";
    case Colour::limit_without_need: return "green, though a limit is listed";
    case Colour::not_judged: return "not judged further";
    case Colour::not_applicable: break;
  }
  return "not applicable";
}

void CellSum::add(const Run& run, int excused_from_ms) {
  const bool is_late = run.begin_ms >= excused_from_ms;
  ++flights;
  late += is_late ? 1 : 0;
  if (run.outcome) {
    ++counts[static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(*run.outcome)))];
  } else {
    ++red;
    red_early += is_late ? 0 : 1;
  }
  if (!worst || is_worse(run, *worst)) {
    worst = run;
  }
}

void CellSum::add(const CellSum& later) {
  flights += later.flights;
  red += later.red;
  late += later.late;
  red_early += later.red_early;
  for (std::size_t i = 0; i < outcomes; ++i) {
    counts[i] += later.counts[i];
  }
  if (later.worst && (!worst || is_worse(*later.worst, *worst))) {
    worst = later.worst;
  }
}

std::string about_rocket(const KnownLimit* limit, const sim::Scenario& scenario) {
  if (limit == nullptr || limit->device != "servo") {
    return {};
  }
  double offset_rad = 0.0;
  for (const sim::DisturbanceNode& node : scenario.disturbance) {
    offset_rad = std::max(offset_rad, std::abs(node.angle_rad));
  }
  const auto shown = [](double angle_rad) { return text::brief(text::degrees(angle_rad), 1); };
  const double limit_rad = static_cast<double>(scenario.plan.controller.canard_limit.radians());
  const double stop_rad = scenario.vehicle.servo.stop_rad;
  const double most_rad = 3.0 * limit_rad - 4.0 * offset_rad;  // of the stop
  if (stop_rad < limit_rad) {
    return fmt::format(
        "The rocket that was flown breaks this rule: its stop of {} deg is inside its plan limit of {} deg",
        shown(stop_rad), shown(limit_rad));
  }
  const std::string sum = fmt::format(
      "4 x {} deg of fin offset + {} deg of stop is {} deg, and 3 x {} deg of plan limit is {} deg", shown(offset_rad),
      shown(stop_rad), shown(4.0 * offset_rad + stop_rad), shown(limit_rad), shown(3.0 * limit_rad));
  if (stop_rad < most_rad) {
    return "The rocket that was flown keeps this rule: " + sum;
  }
  return fmt::format(
      "The rocket that was flown breaks this rule: {}. {}", sum,
      most_rad > limit_rad
          ? fmt::format("A stop between {} and {} deg keeps it", shown(limit_rad), shown(most_rad))
          : fmt::format(
                "No stop keeps it: one at the plan limit makes {} deg. What does is less fin offset, or a larger "
                "plan limit with a stop just beyond it",
                shown(4.0 * offset_rad + limit_rad)));
}

CellResult conclude(const Cell& cell, const CellSum& sum, const KnownLimit* limit) {
  const bool excused = limit != nullptr && sum.late > 0 && sum.red_early == 0;
  CellResult result{.cell = cell,
                    .flights = sum.flights,
                    .red = sum.red,
                    .counts = sum.counts,
                    .worst = sum.worst,
                    .limit = excused ? limit : nullptr};
  if (!sum.worst) {
    return result;
  }
  result.figure = figure_of(*result.worst);
  constexpr auto anything = static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(Outcome::anything)));
  if (sum.red > 0) {
    result.colour = excused ? Colour::known_limit : Colour::red;
  } else if (sum.counts[anything] > 0) {
    result.colour = Colour::not_judged;
  } else {
    result.colour = excused ? Colour::limit_without_need : Colour::green;
  }
  return result;
}

CellResult concluded(const Cell& cell, const std::vector<Run>& runs, const KnownLimit* limit, int excused_from_ms) {
  CellSum sum;
  for (const Run& run : runs) {
    sum.add(run, excused_from_ms);
  }
  return conclude(cell, sum, limit);
}

}  // namespace fantail::faults
