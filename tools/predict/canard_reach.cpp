// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include "core/flight_plan.hpp"
#include "flight/flight.hpp"
#include "predict/margins.hpp"
#include "sim/deflection_range.hpp"
#include "stability/speed_range.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

/// The first of all limits that ends a canard before the plan's own does; empty: none does.
std::string stopped_by(const sim::Scenario& scenario) {
  double least_rad = static_cast<double>(scenario.plan.controller.canard_limit.radians()) - same_angle_rad;
  std::string name;
  const auto keep_smaller = [&](double limit_rad, std::string what) {
    if (limit_rad < least_rad) {
      least_rad = limit_rad;
      name = std::move(what);
    }
  };
  keep_smaller(static_cast<double>(core::hard_canard_limit.radians()), "hard limit");
  const auto& canards = scenario.plan.canards.each;
  for (std::size_t i = 0; i < canards.size(); ++i) {
    keep_smaller(static_cast<double>(canards[i].mechanical_stop.radians()),
                 fmt::format("mechanical stop of canard {} in the plan", i + 1));
  }
  keep_smaller(scenario.vehicle.servo.stop_rad, "servo stop");
  if (scenario.vehicle.canard_air.stall_rad) {
    keep_smaller(*scenario.vehicle.canard_air.stall_rad, "canard stall");
  }
  return name;
}

}  // namespace

std::string CanardReach::text() const {
  const std::string angle = text::brief(text::degrees(angle_rad), 1);
  return set_by.empty() ? angle + " degree canard limit"
                        : fmt::format("{} degrees that the canards reach ({})", angle, set_by);
}

CanardReach canard_reach(const sim::Scenario& scenario, double offset_rad) {
  const sim::DeflectionRange range = sim::deflection_range(scenario);
  CanardReach found{.angle_rad = offset_rad > 0.0 ? -range.lowest_rad : range.highest_rad,
                    .set_by = stopped_by(scenario)};
  const bool broken = std::ranges::any_of(scenario.faults, [](const sim::Fault& fault) {
    return sim::broken_gear(fault) != nullptr && sim::is_there_at_liftoff(fault);
  });
  const double limit_rad = flight::canard_limit_rad(scenario.plan);
  if (broken) {
    found.set_by = "canard faults of the scenario";
  } else if (scenario.vehicle.canard_air.wash > 0.0) {
    found.set_by += found.set_by.empty() ? "wash of the canards on the fins" : " and wash of the canards on the fins";
  } else if (found.set_by.empty() && std::abs(found.angle_rad - limit_rad) > same_angle_rad) {
    found.set_by = "canard limit and the trim of the canards";
  }
  return found;
}

CanardReach farthest_reach(const sim::Scenario& scenario, double offset_rad) {
  sim::Scenario widest = scenario;
  widest.plan.controller.canard_limit =
      core::Angle::from_radians(static_cast<float>(stability::plan_range("controller", "canard_limit_deg").maximum));
  return canard_reach(widest, offset_rad);
}

}  // namespace fantail::predict
