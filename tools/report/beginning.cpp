// SPDX-License-Identifier: MIT
#include "report/beginning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/hold.hpp"

namespace fantail::report {

void NeutralWatch::add(const flight::Row& row, const flight::Flight& flight) {
  using enum core::Phase;
  if (row.phase == safe && !is_over_) {
    neutral_ = {};
  }
  is_over_ = is_over_ || row.phase == controlling || row.phase == finished;
  if (is_over_ || row.phase == safe || !flight.known.plan || !flight.known.phase) {
    return;
  }
  const double since_s = row.time_s - neutral_.until_s.value_or(row.time_s);
  neutral_.from_s = neutral_.from_s.value_or(row.time_s);
  neutral_.until_s = row.time_s;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const auto trim_rad = static_cast<double>(flight.plan.canards.each[i].trim.radians());
    if (row.commands_rad[i]) {
      neutral_.command_rad = std::max(neutral_.command_rad.value_or(0.0), std::abs(*row.commands_rad[i] - trim_rad));
    }
    if (row.encoders_rad[i]) {
      neutral_.encoder_rad = std::max(neutral_.encoder_rad.value_or(0.0), std::abs(*row.encoders_rad[i] - trim_rad));
    }
  }
  const bool all_read = std::ranges::all_of(row.encoders_rad, [](const auto& angle) { return angle.has_value(); });
  const bool is_hole = since_s > RunningExtent::shortest_hole_s;
  neutral_.missing_s += is_hole ? since_s : 0.0;
  neutral_.unread_s += all_read || is_hole ? 0.0 : since_s;
}

Neutral NeutralWatch::found(const flight::Clock& clock) const {
  Neutral result = neutral_;
  for (std::optional<double>* time_s : {&result.from_s, &result.until_s}) {
    *time_s = *time_s ? std::optional{clock(**time_s)} : std::nullopt;
  }
  for (double* all_s : {&result.unread_s, &result.missing_s}) {
    *all_s = std::round(1e4 * *all_s) / 1e4;  // whatever the clock of the rows
  }
  return result;
}

void OpeningWatch::add(const flight::Row& row, double roll_rad) {
  using enum core::Phase;
  const std::optional<core::Phase> before = before_;
  before_ = row.phase;
  const bool follows = last_s_ && row.time_s - *last_s_ <= RunningExtent::shortest_hole_s;
  last_s_ = row.time_s;
  if (before == controlling && row.phase == dormant) {
    ++opening_.closings;
  }
  const bool begins = row.phase == dormant && before && before != dormant;
  const bool ends = before == dormant && row.phase != dormant;
  if (begins) {
    dormant_from_rad_ = roll_rad;
    is_waiting_ = true;
  }
  knows_turns_ = knows_turns_ && (follows || !(begins || ends));
  if (is_waiting_ && knows_turns_) {
    const double turns = turns_before_ + (roll_rad - dormant_from_rad_) / (2.0 * std::numbers::pi);
    opening_.dormant_turns = if_finite(turns);
    turns_before_ = ends ? turns : turns_before_;
  } else if (!knows_turns_) {
    opening_.dormant_turns.reset();
  }
  is_waiting_ = is_waiting_ && row.phase == dormant;
  if (row.phase == controlling && !is_open_) {
    is_open_ = true;
    misses_start_ = !follows;
    if (misses_start_) {
      return;
    }
    opening_.speed_m_s = if_finite(flight::best_known(row, &flight::Truth::speed_m_s, row.speed_m_s));
    opening_.roll_angle_rad = if_finite(roll_rad);
    opening_.roll_rate_rad_s = if_finite(flight::best_known(row, &flight::Truth::roll_rate_rad_s, row.roll_rate_rad_s));
  }
}

void CaptureWatch::add(const flight::Row& row, const std::optional<double>& error_rad) {
  if (!first_s_) {
    reference_rad_ = row.reference_rad;
  }
  const bool is_slow =
      !tunnel_ && flight::best_known(row, &flight::Truth::speed_m_s, row.speed_m_s) < flight::slowest_held_m_s;
  is_over_ = is_over_ || !error_rad || is_slow || row.reference_rad != reference_rad_;
  if (is_over_) {
    return;
  }
  first_s_ = first_s_.value_or(row.time_s);
  last_s_ = row.time_s;
  knows_saturation_ = knows_saturation_ && row.saturated;
  all_.ticks += 1;
  all_.saturated += row.saturated.value_or(false) ? 1 : 0;
  if (std::abs(*error_rad) > Capture::near_rad) {
    near_since_s_.reset();
    before_ = all_;
    return;
  }
  near_since_s_ = near_since_s_.value_or(row.time_s);
  is_over_ = row.time_s - *near_since_s_ > Capture::stays_s - row_time_rounding_s;
}

Capture CaptureWatch::found(const flight::Clock& clock) const {
  Capture result;
  if (!first_s_) {
    return result;
  }
  result.watched_s = clock(last_s_) - clock(*first_s_);
  const bool stayed = near_since_s_ && last_s_ - *near_since_s_ > Capture::stays_at_end_s - row_time_rounding_s;
  if (stayed) {
    result.after_s = clock(*near_since_s_) - clock(*first_s_);
  }
  const Count& until = stayed ? before_ : all_;
  if (knows_saturation_ && until.ticks > 0) {
    result.saturated_fraction = static_cast<double>(until.saturated) / static_cast<double>(until.ticks);
  }
  return result;
}

bool holds_an_angle(const flight::Flight& flight) {
  return !flight.tunnel && flight.why_uncontrollable.empty() &&
         (!flight.known.plan || flight.plan.controller.proportional_gain > 0.0F);
}

Capture measured_capture(const flight::Flight& flight, std::span<const flight::Row> control) {
  CaptureWatch watch{flight.tunnel};
  if (!holds_an_angle(flight) || control.empty()) {
    return {};
  }
  const flight::Row& first = control.front();
  const auto end =
      std::ranges::find_if(control, [&](const flight::Row& row) { return row.reference_rad != first.reference_rad; });
  const auto settled = std::find_if(control.begin(), end, [&](const flight::Row& row) {
    return row.time_s - first.time_s > first_settling_time_s(flight) - row_time_rounding_s;
  });
  double sum_rad = 0.0;
  std::size_t rows = 0;
  double last_s = first.time_s;
  for (auto row = settled; row != end && row->time_s - settled->time_s <= Capture::stays_s; ++row) {
    sum_rad += row->roll_angle_rad;
    rows += 1;
    last_s = row->time_s;
  }
  if (rows == 0 || last_s - settled->time_s < shortest_rest_s || !std::isfinite(sum_rad)) {
    return {};
  }
  const double rest_rad = sum_rad / static_cast<double>(rows);
  std::for_each(control.begin(), end,
                [&](const flight::Row& row) { watch.add(row, if_finite(row.roll_angle_rad - rest_rad)); });
  return watch.found({});
}

}  // namespace fantail::report
