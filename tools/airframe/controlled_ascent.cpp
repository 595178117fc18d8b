// SPDX-License-Identifier: MIT
#include "airframe/controlled_ascent.hpp"

#include <algorithm>

#include "sim/ascent.hpp"
#include "sim/scenario.hpp"

namespace fantail::airframe {
namespace {

/// Control goes on to apogee; slower than this its loop is not judged, as by fantail plan check.
constexpr double slowest_m_s = 20.0;

}  // namespace

double ControlledAscent::thinner(double speed_m_s) const {
  const sim::Atmosphere air = sim::Scenario{}.atmosphere;
  const auto at = std::ranges::find_if(coast, [&](const Moment& one) { return one.speed_m_s <= speed_m_s; });
  const double height_m = at != coast.end() ? at->height_m : coast.empty() ? 0.0 : coast.back().height_m;
  return air.density_kg_m3(height_m) / air.density_kg_m3(0.0);
}

std::optional<ControlledAscent> controlled_ascent(const sim::Vehicle& vehicle, const core::FlightPlan& plan) {
  constexpr double tick_s = 1e-3;
  constexpr double longest_s = 600.0;
  sim::Ascent ascent{{.mass_kg = vehicle.mass_kg,
                      .drag_area_m2 = vehicle.drag_area_m2,
                      .motor = vehicle.motor,
                      .drag_over_mach = vehicle.drag_over_mach}};
  const auto from_m = static_cast<double>(plan.guide.length_m + plan.guide.clearance_m);
  const auto from_m_s = static_cast<double>(plan.guide.minimum_speed_m_s);
  const auto threshold_m_s2 = static_cast<double>(plan.launch_detection.threshold_m_s2);
  const auto hold_s = static_cast<double>(core::seconds(plan.launch_detection.hold));
  double pushed_s = 0.0;
  bool detected = false;
  std::optional<ControlledAscent> found;
  const auto is_over = [&events = ascent.events()] { return events.burnout_s && events.apogee_s; };
  for (int i = 0; i * tick_s < longest_s && !is_over(); ++i) {
    ascent.advance_to(i * tick_s);
    const double speed_m_s = ascent.speed_m_s();
    pushed_s = ascent.axial_specific_force_m_s2() >= threshold_m_s2 ? pushed_s + tick_s : 0.0;
    detected = detected || pushed_s >= hold_s;
    if (detected && !found && ascent.distance_m() >= from_m && speed_m_s >= from_m_s) {
      found = ControlledAscent{.range = {std::min(speed_m_s, slowest_m_s), speed_m_s}, .begin_m_s = speed_m_s};
    } else if (found && speed_m_s >= found->range.highest_m_s) {
      found->range.highest_m_s = speed_m_s;
      found->coast.clear();
    } else if (found) {
      found->coast.push_back({.speed_m_s = speed_m_s, .height_m = ascent.height_m()});
    }
  }
  return found;
}

}  // namespace fantail::airframe
