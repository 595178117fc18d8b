// SPDX-License-Identifier: MIT
#include "sil/truth_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "degree.hpp"

namespace fantail::sil {
namespace {

/// The factor on the gains, by the plan's words alone.
double factor(const core::GainSchedulePlan& plan, double speed_m_s, bool is_lower_bound) {
  if (plan.speeds_count == 0) {
    return 1.0;
  }
  const std::size_t last = plan.speeds_count - 1U;
  if (is_lower_bound || speed_m_s >= static_cast<double>(plan.speeds_m_s[last])) {
    return static_cast<double>(plan.factors[last]);
  }
  double value = static_cast<double>(plan.factors[0]);
  for (std::size_t i = 0; i < last; ++i) {
    const double from = static_cast<double>(plan.speeds_m_s[i]);
    const double to = static_cast<double>(plan.speeds_m_s[i + 1]);
    const double share = std::clamp((speed_m_s - from) / (to - from), 0.0, 1.0);
    value += share * static_cast<double>(plan.factors[i + 1] - plan.factors[i]);
  }
  return value;
}

}  // namespace

bool Oracle::lasted(double margin_s) const { return end_before_apogee_s < margin_s; }

bool Oracle::steady() const {
  return judged_s > least_judged_s - rounding_s && largest_error_deg <= promised_deg + rounding_deg &&
         lasted(early_s + rounding_s);
}

Oracle look(const flight::Flight& flight) {
  Oracle o;
  const double kp = static_cast<double>(flight.plan.controller.proportional_gain);
  std::optional<double> zero_rad;
  std::optional<double> end_rad;
  double counts_from_s = 0.0;
  std::optional<double> counted_to_s;
  double reference_rad = 0.0;
  double end_s = 0.0;
  for (const flight::Row& row : flight.rows) {
    const bool control = row.phase == core::Phase::controlling;
    if (row.phase == core::Phase::launched && !zero_rad) {
      zero_rad = row.truth->roll_angle_rad;
    }
    if (row.phase == core::Phase::armed) {
      zero_rad.reset();  // that was no launch
    }
    if (control && (!o.controlled || row.reference_rad != reference_rad)) {
      counts_from_s = row.time_s + 1.0;
      counted_to_s.reset();
      reference_rad = row.reference_rad;
    }
    if (control) {
      o.controlled = true;
      end_rad = row.truth->roll_angle_rad;
      end_s = row.time_s;
      o.unbalanced_deg = std::copysign(1.0, row.truth->disturbance_rad) *
                         (row.truth->disturbance_rad + row.truth->canard_rad) / degree;
      o.largest_offset_deg = std::max(o.largest_offset_deg, std::abs(row.truth->disturbance_rad) / degree);
      if (kp > 0.0 && row.time_s >= counts_from_s - 1e-6) {
        const bool bound = row.time_s >= flight.unmeasured.speed_bound_from_s.value_or(1e9);
        const double beside_rad =
            flight.plan.offset.rejection != core::OffsetRejection::none
                ? 0.0
                : row.truth->disturbance_rad / (kp * factor(flight.plan.gain_schedule, row.speed_m_s, bound));
        const double away_rad = row.truth->roll_angle_rad - *zero_rad - row.reference_rad - beside_rad;
        o.largest_error_deg = std::max(o.largest_error_deg, std::abs(away_rad) / degree);
        o.judged_s += counted_to_s ? row.time_s - *counted_to_s : 0.0;
        counted_to_s = row.time_s;
      }
    } else if (o.controlled && row.time_s <= flight.events.apogee_s.value_or(0.0)) {
      o.turned_after_deg = std::max(o.turned_after_deg, std::abs(row.truth->roll_angle_rad - *end_rad) / degree);
    }
  }
  o.end_before_apogee_s = flight.events.apogee_s.value_or(end_s) - end_s;
  return o;
}

}  // namespace fantail::sil
