// SPDX-License-Identifier: MIT
#include "faults/stop_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <fmt/core.h>

#include "sim/canard_aerodynamics.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::faults {
namespace {

std::string shown(double angle_rad) { return text::brief(text::degrees(angle_rad), 1); }

/// 1: the positive stop, -1: the negative one, 0: either.
double side_of_stop(const sim::Fault& fault) {
  const auto* gear = std::get_if<sim::GearFault>(&fault.how);
  if (gear == nullptr) {
    return 0.0;
  }
  return gear->fault == sim::ServoFault::hardover ? 1.0 : gear->angle_rad ? std::copysign(1.0, *gear->angle_rad) : 0.0;
}

/// The largest one that turns the rocket as the stop does.
double offset_with_stop_rad(const sim::Scenario& scenario, const sim::Fault& fault) {
  const double side = side_of_stop(fault);
  double most_rad = -std::numeric_limits<double>::infinity();
  for (const sim::DisturbanceNode& node : scenario.disturbance) {
    for (const sim::CanardMounting& canard : scenario.vehicle.canards) {
      const double at_positive_stop_rad = canard.reversed ? -node.angle_rad : node.angle_rad;
      most_rad = std::max(most_rad, side == 0.0 ? std::abs(node.angle_rad) : side * at_positive_stop_rad);
    }
  }
  return most_rad;
}

std::string flown_with_nearest_stop(const Cell& cell, const Run& run, const Twins& twins, double stop_rad) {
  sim::Scenario scenario = twins.scenario;
  scenario.seed = run.seed;
  scenario.vehicle.servo.stop_rad = stop_rad;
  try {
    const Twins twin_of_it = fly_twins(scenario, 1);
    const Findings found = fly_run(twin_of_it, cell, {.seed = 0, .begin_ms = run.begin_ms}, run.number);
    return fmt::format(
        "Flown again with a stop at {} deg, the worst flight has {:.1f} deg of roll difference instead of {:.1f}: {}",
        shown(stop_rad), found.apart_deg, run.apart_deg, found.outcome(cell.expected()) ? "safe" : "still not safe");
  } catch (const text::Error&) {
    return {};  // with this stop the rocket does not fly without the fault either
  }
}

}  // namespace

StopRule::StopRule(const sim::Scenario& scenario, const sim::Fault& fault)
    : offset_rad_{offset_with_stop_rad(scenario, fault)},
      limit_rad_{static_cast<double>(scenario.plan.controller.canard_limit.radians())},
      stop_rad_{scenario.vehicle.servo.stop_rad},
      acts_as_rad_{sim::lift_angle_rad(scenario.vehicle.canard_air, stop_rad_)} {}

double StopRule::nearest_rad() const { return limit_rad_ + text::radians(0.5); }

std::string StopRule::sentence() const {
  if (stop_rad_ < limit_rad_) {
    return fmt::format("This rocket breaks the rule: its stop of {} deg is inside its plan limit of {} deg",
                       shown(stop_rad_), shown(limit_rad_));
  }
  const std::string stop = acts_as_rad_ < stop_rad_ ? fmt::format("{} deg of stall", shown(acts_as_rad_))
                                                    : fmt::format("{} deg of stop", shown(stop_rad_));
  const std::string sum =
      fmt::format("4 x {} deg of fin offset + {} is {} deg, and 3 x {} deg of plan limit is {} deg", shown(offset_rad_),
                  stop, shown(4.0 * offset_rad_ + acts_as_rad_), shown(limit_rad_), shown(3.0 * limit_rad_));
  return fmt::format(
      "This rocket breaks the rule: {}. {}", sum,
      farthest_rad() > limit_rad_
          ? fmt::format("A stop between {} and {} deg keeps the rule", shown(limit_rad_), shown(farthest_rad()))
          : fmt::format("No stop keeps the rule: one at the plan limit gives {} deg. Reduce the fin offset, or use a "
                        "larger plan limit with a stop just beyond it",
                        shown(4.0 * offset_rad_ + limit_rad_)));
}

std::string about_stop(const CellResult& cell, const Twins& twins) {
  if (cell.limit == nullptr || cell.limit->excuse == Excuse::any) {
    return {};
  }
  const StopRule rule{twins.scenario, cell.cell.row->recipe.fault};
  std::string of_rocket = rule.is_kept() ? std::string{} : rule.sentence();
  if (cell.colour != Colour::known_limit || rule.stop_rad() <= rule.nearest_rad()) {
    return of_rocket;
  }
  const std::string tried = flown_with_nearest_stop(cell.cell, *cell.worst, twins, rule.nearest_rad());
  return of_rocket + (of_rocket.empty() || tried.empty() ? "" : ". ") + tried;
}

}  // namespace fantail::faults
