// SPDX-License-Identifier: MIT
#include "faults/stop_rule.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::faults {
namespace {

std::string shown(double angle_rad) { return text::brief(text::degrees(angle_rad), 1); }

double largest_offset_rad(const sim::Scenario& scenario) {
  double offset_rad = 0.0;
  for (const sim::DisturbanceNode& node : scenario.disturbance) {
    offset_rad = std::max(offset_rad, std::abs(node.angle_rad));
  }
  return offset_rad;
}

std::string flown_with_nearest_stop(const Cell& cell, const Run& run, const Twins& twins, double stop_rad) {
  sim::Scenario scenario = twins.scenario;
  scenario.seed = run.seed;
  scenario.vehicle.servo.stop_rad = stop_rad;
  try {
    const Twins nearer = fly_twins(scenario, 1);
    const Findings found = fly_run(nearer, cell, {.seed = 0, .begin_ms = run.begin_ms}, run.number);
    return fmt::format(
        ". Flown again with a stop at {} deg, the worst flight is {:.1f} deg apart instead of {:.1f}: {}",
        shown(stop_rad), found.apart_deg, run.apart_deg, found.outcome(cell.expected()) ? "safe" : "still not safe");
  } catch (const text::Error&) {
    return {};  // with this stop the rocket does not fly without the fault either
  }
}

}  // namespace

StopRule::StopRule(const sim::Scenario& scenario)
    : offset_rad_{largest_offset_rad(scenario)},
      limit_rad_{static_cast<double>(scenario.plan.controller.canard_limit.radians())},
      stop_rad_{scenario.vehicle.servo.stop_rad} {}

double StopRule::nearest_rad() const { return limit_rad_ + text::radians(0.5); }

std::string StopRule::sentence() const {
  if (stop_rad_ < limit_rad_) {
    return fmt::format(
        "The rocket that was flown breaks this rule: its stop of {} deg is inside its plan limit of {} deg",
        shown(stop_rad_), shown(limit_rad_));
  }
  const std::string sum = fmt::format(
      "4 x {} deg of fin offset + {} deg of stop is {} deg, and 3 x {} deg of plan limit is {} deg", shown(offset_rad_),
      shown(stop_rad_), shown(4.0 * offset_rad_ + stop_rad_), shown(limit_rad_), shown(3.0 * limit_rad_));
  return fmt::format(
      "The rocket that was flown breaks this rule: {}. {}", sum,
      farthest_rad() > limit_rad_
          ? fmt::format("A stop between {} and {} deg keeps it", shown(limit_rad_), shown(farthest_rad()))
          : fmt::format("No stop keeps it: one at the plan limit makes {} deg. Less fin offset does, or a larger plan "
                        "limit with a stop just beyond it",
                        shown(4.0 * offset_rad_ + limit_rad_)));
}

bool is_of_one_canard(const KnownLimit& limit) { return limit.device == "servo"; }

std::string about_stop(const CellResult& cell, const Twins& twins) {
  if (cell.limit == nullptr || !is_of_one_canard(*cell.limit)) {
    return {};
  }
  const StopRule rule{twins.scenario};
  const bool is_tried = cell.colour == Colour::known_limit && rule.stop_rad() > rule.nearest_rad();
  return rule.sentence() +
         (is_tried ? flown_with_nearest_stop(cell.cell, *cell.worst, twins, rule.nearest_rad()) : std::string{});
}

}  // namespace fantail::faults
