// SPDX-License-Identifier: MIT
#include "report/figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace fantail::report {
namespace {

// A clamped step of 45 deg takes longer than a second to arrive at the tunnel's 22 m/s (peak at 1.7 s).
constexpr double settling_time_in_flight_s = 1.0;
constexpr double settling_time_in_tunnel_s = 2.0;
// Shorter than this, a saturation at the end of control is the excitation or the thin air near apogee.
constexpr double lasting_saturation_s = 0.5;
// Rows are a millisecond apart and their times are rounded to the microsecond.
constexpr double clock_tolerance_s = 1e-6;

// The truth where it is known.
double better(const flight::Row& row, double flight::Truth::* truth, double estimate) {
  return row.truth && std::isfinite((*row.truth).*truth) ? (*row.truth).*truth : estimate;
}
double height_m(const flight::Row& row) { return better(row, &flight::Truth::height_m, row.height_m); }
double speed_m_s(const flight::Row& row) { return better(row, &flight::Truth::speed_m_s, row.speed_m_s); }
double roll_angle_rad(const flight::Row& row) {
  return better(row, &flight::Truth::roll_angle_rad, row.roll_angle_rad);
}

std::optional<double> known(double value) { return std::isfinite(value) ? std::optional{value} : std::nullopt; }

std::optional<double> largest(const flight::Flight& flight, double (*value)(const flight::Row&)) {
  std::optional<double> result;
  for (const flight::Row& row : flight.rows) {
    if (const double one = value(row); std::isfinite(one) && (!result || one > *result)) {
      result = one;
    }
  }
  return result;
}

std::span<const flight::Row> under_control(const flight::Flight& flight) {
  const auto is_control = [](const flight::Row& row) { return row.phase == core::Phase::controlling; };
  const auto first = std::ranges::find_if(flight.rows, is_control);
  return {first, std::find_if_not(first, flight.rows.end(), is_control)};
}

void judge_hold(Figures& f, std::span<const flight::Row> control, const flight::Flight& flight) {
  const double settling_time_s = flight.tunnel ? settling_time_in_tunnel_s : settling_time_in_flight_s;
  const double zero_rad = true_zero_rad(flight);
  double settles_at_s = control.front().time_s + settling_time_s;
  double reference_rad = control.front().reference_rad;
  double sum_rad = 0.0;
  std::size_t count = 0;
  for (const flight::Row& row : control) {
    if (row.reference_rad != reference_rad) {
      reference_rad = row.reference_rad;
      settles_at_s = row.time_s + settling_time_s;
    }
    const std::optional<double> settle_point = flight::settle_point_rad(row, flight);
    if (!settle_point || row.time_s < settles_at_s - clock_tolerance_s) {
      continue;
    }
    const double roll_rad =
        std::isfinite(row.truth->roll_angle_rad) ? row.truth->roll_angle_rad - zero_rad : row.roll_angle_rad;
    const double error_rad = std::abs(roll_rad - *settle_point);
    f.largest_hold_error_rad = std::max(f.largest_hold_error_rad.value_or(0.0), error_rad);
    sum_rad += error_rad;
    ++count;
  }
  if (count > 0) {
    f.mean_hold_error_rad = sum_rad / static_cast<double>(count);
  }
}

void keep_larger(std::optional<double>& kept, double value) {
  if (std::isfinite(value) && (!kept || std::abs(value) > std::abs(*kept))) {
    kept = value;
  }
}

void judge_authority(Figures& f, std::span<const flight::Row> control, const flight::Flight& flight) {
  // The margin is a roof over the offset: of all offsets between the least and the largest, one of these two has the
  // least margin.
  std::optional<double> least_rad;
  std::optional<double> most_rad;
  for (const flight::Row& row : control) {
    if (row.truth && std::isfinite(row.truth->disturbance_rad)) {
      const double offset_rad = row.truth->disturbance_rad;
      keep_larger(f.largest_disturbance_rad, offset_rad);
      least_rad = std::min(least_rad.value_or(offset_rad), offset_rad);
      most_rad = std::max(most_rad.value_or(offset_rad), offset_rad);
    }
  }
  if (!least_rad || !flight.known.plan) {
    return;
  }
  const double at_least = flight::authority_margin_rad(flight, *least_rad);
  const double at_most = flight::authority_margin_rad(flight, *most_rad);
  const double offset_rad = at_least < at_most ? *least_rad : *most_rad;
  f.authority_margin_rad = std::min(at_least, at_most);
  f.authority_rad = flight::authority_rad(flight, -offset_rad);
}

void judge_saturation(Figures& f, std::span<const flight::Row> control, const flight::Flight& flight) {
  const auto saturated = std::ranges::count_if(control, &flight::Row::saturated);
  f.saturated_fraction = static_cast<double>(saturated) / static_cast<double>(control.size());

  const auto last_free =
      std::find_if_not(control.rbegin(), control.rend(), [](const flight::Row& r) { return r.saturated; });
  const std::span<const flight::Row> run = control.last(static_cast<std::size_t>(last_free - control.rbegin()));
  if (run.empty() || run.back().time_s - run.front().time_s < lasting_saturation_s) {
    return;
  }
  f.at_limit_since_s = run.front().time_s;
  for (const flight::Row& row : run) {
    if (row.truth) {
      keep_larger(f.offset_at_limit_rad, row.truth->disturbance_rad);
      // What is left turns the rocket against the command. A canard that broke in flight can happen to help.
      const bool unbalanced = (row.truth->disturbance_rad + row.truth->canard_rad) * row.command_rad < 0.0;
      f.offset_beyond_limit =
          flight.known.plan && unbalanced && flight::authority_margin_rad(flight, row.truth->disturbance_rad) < 0.0;
    }
  }
}

void judge_end(Figures& f, std::span<const flight::Row> control, const flight::Flight& flight) {
  const std::optional<double>& apogee_s = flight.events.apogee_s;
  if (!apogee_s || !flight.events.control_end_s) {
    return;
  }
  f.ended_before_apogee_s = *apogee_s - *flight.events.control_end_s;
  const double end_rad = roll_angle_rad(control.back());
  const bool ended_well_before = *f.ended_before_apogee_s > 0.1;
  for (const flight::Row& row : flight.rows) {
    // A gap may have swallowed all of them: then the first behind it shows what happened.
    const bool counts = row.time_s <= *apogee_s || (ended_well_before && !f.roll_after_end_rad);
    if (row.time_s > control.back().time_s && counts) {
      const double rolled_rad = std::abs(roll_angle_rad(row) - end_rad);
      f.roll_after_end_rad = std::max(f.roll_after_end_rad.value_or(0.0), rolled_rad);
    }
  }
}

/// In wind the rows' true speed is the one through the air, along the rocket's axis.
double top_speed_over_ground_m_s(const std::vector<flight::PathPoint>& path) {
  double top_m_s = 0.0;
  for (const flight::PathPoint& point : path) {
    top_m_s = std::max(top_m_s, std::hypot(point.north_m_s, point.east_m_s, point.up_m_s));
  }
  return top_m_s;
}

}  // namespace

double true_zero_rad(const flight::Flight& flight) {
  const std::optional<double>& zero_s = flight.tunnel ? flight.events.control_start_s : flight.events.detected_s;
  const auto at = std::ranges::find_if(
      flight.rows, [&](const flight::Row& row) { return zero_s && row.time_s >= *zero_s - clock_tolerance_s; });
  const bool known = at != flight.rows.end() && at->truth && std::isfinite(at->truth->roll_angle_rad);
  return known ? at->truth->roll_angle_rad : 0.0;
}

Figures figures(const flight::Flight& flight) {
  Figures f;
  if (flight.rows.empty()) {
    return f;
  }
  f.final_phase = flight.rows.back().phase;
  f.max_speed_m_s = flight.path.empty() ? largest(flight, speed_m_s) : top_speed_over_ground_m_s(flight.path);
  if (!flight.tunnel && flight.events.apogee_s) {
    f.apogee_m = largest(flight, height_m);
  }
  const std::span<const flight::Row> control = under_control(flight);
  if (control.empty()) {
    return f;
  }
  if (!flight.tunnel) {
    f.control_start_height_m = known(height_m(control.front()));
  }
  f.control_time_s = control.back().time_s - control.front().time_s;
  f.command_at_end_rad = control.back().command_rad;
  f.roll_turns = known((roll_angle_rad(control.back()) - roll_angle_rad(control.front())) / (2.0 * std::numbers::pi));
  judge_hold(f, control, flight);
  judge_authority(f, control, flight);
  judge_end(f, control, flight);
  f.oscillation = find_oscillation(control, flight.tunnel ? settling_time_in_tunnel_s : settling_time_in_flight_s);
  f.side_deflection = side_deflection(flight, control);
  if (flight.known.saturation) {
    judge_saturation(f, control, flight);
  }
  return f;
}

}  // namespace fantail::report
