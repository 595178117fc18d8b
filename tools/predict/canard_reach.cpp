// SPDX-License-Identifier: MIT
#include "predict/canard_reach.hpp"

#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include "core/flight_plan.hpp"
#include "predict/plan_ranges.hpp"

namespace fantail::predict {
namespace {

void keep_smaller(CanardReach& reach, double angle_rad, std::string set_by) {
  if (angle_rad < reach.angle_rad) {
    reach = {.angle_rad = angle_rad, .set_by = std::move(set_by)};
  }
}

CanardReach reach_with(double plan_limit_rad, const sim::Scenario& scenario) {
  CanardReach reach{.angle_rad = plan_limit_rad};
  keep_smaller(reach, static_cast<double>(core::hard_canard_limit.radians()), "hard limit");
  const auto& canards = scenario.plan.canards.each;
  for (std::size_t i = 0; i < canards.size(); ++i) {
    keep_smaller(reach, static_cast<double>(canards[i].mechanical_stop.radians()),
                 fmt::format("mechanical stop of canard {} in the plan", i + 1));
  }
  keep_smaller(reach, scenario.vehicle.servo.stop_rad, "servo stop");
  return reach;
}

}  // namespace

CanardReach canard_reach(const sim::Scenario& scenario) {
  return reach_with(static_cast<double>(scenario.plan.controller.canard_limit.radians()), scenario);
}

CanardReach farthest_reach(const sim::Scenario& scenario) {
  return reach_with(plan_range("canard_limit_deg").maximum, scenario);
}

}  // namespace fantail::predict
