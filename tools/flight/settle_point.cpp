// SPDX-License-Identifier: MIT
// Where the law of a plan comes to rest.
#include <cmath>

#include "core/gain_schedule.hpp"
#include "flight/flight.hpp"

namespace fantail::flight {
namespace {

bool only_bounds_speed(const Row& row, const Flight& flight) {
  const std::optional<double>& from_s = flight.unmeasured.speed_bound_from_s;
  return from_s && row.time_s >= *from_s;
}

bool knows_gains(const Row& row, const core::FlightPlan& plan, bool speed_is_lower_bound) {
  return plan.gain_schedule.speeds_count == 0 || speed_is_lower_bound || std::isfinite(row.speed_m_s);
}

std::optional<double> settles_at_rad(const Row& row, const core::FlightPlan& plan, double left_by_fins,
                                     bool speed_is_lower_bound) {
  if (!knows_gains(row, plan, speed_is_lower_bound)) {
    return std::nullopt;
  }
  const auto speed_m_s = static_cast<float>(std::isfinite(row.speed_m_s) ? row.speed_m_s : 0.0);
  const core::GainSchedulePlan& schedule = plan.gain_schedule;  // asked in every row: most plans have none
  const float factor = schedule.speeds_count == 0 ? 1.0F : core::gain_factor(schedule, speed_m_s, speed_is_lower_bound);
  const float gain = factor * plan.controller.proportional_gain;
  if (!row.truth || gain == 0.0F) {
    return std::nullopt;
  }
  const double share = rejects_offset(plan) ? 0.0 : 1.0;
  const double off_rad = row.truth->disturbance_rad / (left_by_fins * static_cast<double>(gain));
  const double point_rad = row.reference_rad + share * off_rad;
  return std::isfinite(point_rad) ? std::optional{point_rad} : std::nullopt;
}

}  // namespace

bool has_gains(const core::FlightPlan& plan) {
  return plan.controller.proportional_gain > 0.0F || plan.controller.derivative_gain_s > 0.0F || rejects_offset(plan);
}

bool rejects_offset(const core::FlightPlan& plan) { return plan.offset.rejection != core::OffsetRejection::none; }

bool gains_are_known(const Row& row, const Flight& flight) {
  return flight.known.plan && knows_gains(row, flight.plan, only_bounds_speed(row, flight));
}

std::optional<double> settle_point_rad(const Row& row, const core::FlightPlan& plan) {
  return settles_at_rad(row, plan, 1.0, false);
}

std::optional<double> settle_point_rad(const Row& row, const Flight& flight) {
  if (!flight.known.plan) {
    return std::nullopt;
  }
  return settles_at_rad(row, flight.plan, flight.left_by_fins > 0.0 ? flight.left_by_fins : 1.0,
                        only_bounds_speed(row, flight));
}

}  // namespace fantail::flight
