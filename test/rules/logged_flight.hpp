// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/flight_plan_members.hpp"
#include "flight/flight.hpp"
#include "rules/figures.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

// A log made by hand, and its figures.
namespace fantail::rules::logged {

inline constexpr double endless_s = std::numeric_limits<double>::infinity();

/// Every 10 ms from -1 to 20 s: thrust to 8 s, the largest speed then, control from 9 s on, apogee at 18 s.
inline flight::Flight whole() {
  flight::Flight log;
  log.plan = core::default_plan();
  log.events = {.liftoff_s = 0.0, .detected_s = 0.2, .control_start_s = 9.0, .control_end_s = 18.0};
  log.phase_changes.push_back({18.0, core::Phase::finished, core::PhaseReason::apogee});
  for (int i = -100; i <= 2000; ++i) {
    flight::Row& row = log.rows.emplace_back();
    const double t = row.time_s = i * 0.01;
    row.phase = t < 0.2    ? core::Phase::armed
                : t < 9.0  ? core::Phase::launched
                : t < 18.0 ? core::Phase::controlling
                           : core::Phase::finished;
    row.specific_force_m_s2 = t > 0.0 && t <= 8.0 ? 30.0 : -1.0;
    row.speed_m_s = t < 0.0 ? 0.0 : t <= 8.0 ? 25.0 * t : std::max(0.0, 200.0 - 20.0 * (t - 8.0));
    row.height_m = t < 0.0 ? 0.0 : 1800.0 - 5.0 * (t - 18.0) * (t - 18.0);
    for (std::size_t k = 0; k < core::canard_count; ++k) {
      row.commands_rad[k] = static_cast<double>(log.plan.canards.each[k].trim.radians());
      row.encoders_rad[k] = *row.commands_rad[k] + (t >= 9.0 ? text::radians(3.0) : 0.0);
    }
  }
  return log;
}

inline flight::Flight without(double from_s, double to_s, flight::Flight log = whole()) {
  std::erase_if(log.rows, [&](const flight::Row& row) { return row.time_s > from_s && row.time_s < to_s - 1e-9; });
  return log;
}

/// A log whose event records are lost with their ticks.
inline flight::Flight without_start(double from_s, double to_s) {
  flight::Flight log = without(from_s, to_s);
  log.events.control_start_s.reset();
  return log;
}

/// Of a motor that burns for 8 s.
inline Finding figure(const flight::Flight& log, const std::string& name) {
  return of_log(log, 8.0).at("flight." + name);
}
inline Number number(const flight::Flight& log, const std::string& name) {
  const Finding found = figure(log, name);
  return found.known ? std::get<Number>(*found.known) : Number{NAN, NAN};
}

inline void expect_open(const flight::Flight& log, const std::string& name, const std::string& why) {
  const Finding found = figure(log, name);
  const Number range = found.known ? std::get<Number>(*found.known) : Number{0.0, endless_s};
  EXPECT_LT(range.low, range.high) << name;
  EXPECT_NE(found.how.find(why), std::string::npos) << name << ": " << found.how;
}

}  // namespace fantail::rules::logged
