// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "report/verdict_parts.hpp"

namespace fantail::report {
namespace {

constexpr double threshold_m_s2 = 1.5 * 9.80665;
constexpr double least_s = 0.020;
constexpr double looked_at_s = 1.0;

std::optional<double> apogee_s(const flight::Flight& flight) {
  if (flight.events.apogee_s) {
    return std::max(flight.events.apogee_s, flight.events.burnout_s);  // a motor pulls harder than a parachute
  }
  for (const flight::PhaseChange& change : flight.phase_changes) {
    if (change.reason == core::PhaseReason::apogee) {
      return change.time_s;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Jolt> jolt_after_apogee(const flight::Flight& flight) {
  const std::optional<double> from_s = apogee_s(flight);
  if (flight.tunnel || !from_s) {
    return std::nullopt;
  }
  std::optional<Jolt> jolt;
  bool lasted = false;
  for (const flight::Row& row : flight.rows) {
    if (row.time_s <= *from_s) {
      continue;
    }
    if (lasted && row.time_s - jolt->time_s > looked_at_s) {
      break;
    }
    const double force_m_s2 = std::abs(row.specific_force_m_s2);
    if (force_m_s2 > threshold_m_s2) {
      jolt = jolt.value_or(Jolt{.time_s = row.time_s});
      jolt->specific_force_m_s2 = std::max(jolt->specific_force_m_s2, force_m_s2);
      lasted = lasted || row.time_s - jolt->time_s >= least_s;
    } else if (!lasted) {
      jolt.reset();
    }
  }
  return lasted ? jolt : std::nullopt;
}

}  // namespace fantail::report
