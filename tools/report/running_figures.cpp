// SPDX-License-Identifier: MIT
#include "report/running_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "flight/gate.hpp"

namespace fantail::report {
namespace {

// Shorter than this, a saturation at the end of control is the excitation or the thin air near apogee.
constexpr double lasting_saturation_s = 0.5;
// More than a float, as a plan has its angles, differs from the number.
constexpr double same_angle_rad = 1e-6;

double height_m(const flight::Row& row) { return flight::best_known(row, &flight::Truth::height_m, row.height_m); }
double speed_m_s(const flight::Row& row) { return flight::best_known(row, &flight::Truth::speed_m_s, row.speed_m_s); }
double roll_angle_rad(const flight::Row& row) {
  return flight::best_known(row, &flight::Truth::roll_angle_rad, row.roll_angle_rad);
}

void keep_farthest_from_zero(std::optional<double>& kept, double value) {
  if (std::isfinite(value) && (!kept || std::abs(value) > std::abs(*kept))) {
    kept = value;
  }
}

void keep_error(std::optional<double>& kept, double error_rad) { kept = std::max(kept.value_or(0.0), error_rad); }

/// In wind the rows' true speed is the one through the air, along the rocket's axis.
double top_speed_over_ground_m_s(const std::vector<flight::PathPoint>& path) {
  double top_m_s = 0.0;
  for (const flight::PathPoint& point : path) {
    top_m_s = std::max(top_m_s, std::hypot(point.north_m_s, point.east_m_s, point.up_m_s));
  }
  return top_m_s;
}

}  // namespace

void TrueZero::add(const flight::Row& row) {
  if (phase_ == core::Phase::controlling) {
    return;
  }
  if (row.phase == begins_with_ && phase_ != begins_with_) {
    const bool has_truth = row.truth && std::isfinite(row.truth->roll_angle_rad);
    is_known_ = has_truth && last_s_ && row.time_s - *last_s_ <= RunningExtent::shortest_hole_s;
    rad_ = has_truth ? row.truth->roll_angle_rad : 0.0;
  }
  phase_ = row.phase;
  last_s_ = row.time_s;
}

RunningFigures::RunningFigures(bool tunnel) : zero_{tunnel}, tunnel_{tunnel}, oscillation_{tunnel ? 2.0 : 1.0} {}

void RunningFigures::add(const flight::Row& row, const flight::Flight& flight) {
  begins_under_control_ = begins_under_control_ || (rows_ == 0 && row.phase == core::Phase::controlling);
  rows_ += 1;
  phase_ = row.phase;
  if (std::isfinite(roll_angle_rad(row))) {
    roll_.add(row.time_s);
  }
  add_motion(row);
  in_still_air_ = in_still_air_ && row.truth && std::abs(row.truth->speed_m_s) < Figures::still_air_m_s;
  zero_.add(row);
  camera_roll_.add(row);
  const bool is_true = zero_.is_known() && row.truth && std::isfinite(row.truth->roll_angle_rad);
  const double roll_rad = is_true ? row.truth->roll_angle_rad - zero_.rad() : row.roll_angle_rad;
  neutral_.add(row, flight);
  opening_.add(row, roll_rad);
  change_stage(row, flight);
  switch (stage_) {
    case Stage::before_control:
    case Stage::paused: break;
    case Stage::under_control: add_controlled(row, roll_rad, flight); break;
    case Stage::after_control: look_after_control(row, flight); break;
  }
}

void RunningFigures::change_stage(const flight::Row& row, const flight::Flight& flight) {
  const bool is_control = row.phase == core::Phase::controlling;
  const bool waits = row.phase == core::Phase::dormant;
  if (stage_ == Stage::before_control && is_control) {
    start_ = {.time_s = row.time_s, .height_m = height_m(row)};
    begin_spell(row, flight);
  } else if (stage_ == Stage::under_control && waits) {
    pause_control();
  } else if (stage_ == Stage::paused && is_control) {
    paused_s_ += row.time_s - end_.time_s;
    turned_rad_ += end_.roll_angle_rad - spells_.back().from_rad;
    begin_spell(row, flight);
  } else if (stage_ != Stage::before_control && !is_control && !waits) {
    stage_ = Stage::after_control;
  }
}

void RunningFigures::add_motion(const flight::Row& row) {
  if (const std::optional<double> speed = if_finite(speed_m_s(row))) {
    speed_.add(row.time_s);
    last_speed_m_s_ = *speed;
    if (!largest_speed_m_s_ || *speed > *largest_speed_m_s_) {
      largest_speed_at_s_ = row.time_s;
      largest_speed_m_s_ = *speed;
    }
  }
  if (std::isfinite(height_m(row))) {
    height_.add(row.time_s);
    largest_height_m_ = std::max(largest_height_m_.value_or(height_m(row)), height_m(row));
  }
}

void RunningFigures::begin_spell(const flight::Row& row, const flight::Flight& flight) {
  stage_ = Stage::under_control;
  spells_.push_back({.from_s = row.time_s,
                     .from_rad = roll_angle_rad(row),
                     .capture = CaptureWatch{tunnel_},
                     .turn = flight::chosen_turn(flight, row, row.time_s - start_.time_s)});
}

void RunningFigures::pause_control() {
  stage_ = Stage::paused;
  spells_.back().capture.end();
  hold_.pause();
  rest_.pause();
  oscillation_.pause();
  saturation_.reset();
}

void RunningFigures::add_controlled(const flight::Row& row, double roll_rad, const flight::Flight& flight) {
  controlled_ += 1;
  end_ = {.time_s = row.time_s, .roll_angle_rad = roll_angle_rad(row), .command_rad = row.command_rad};
  hold_.add(row, roll_rad, flight);
  rest_.add(row, roll_rad, flight);
  const auto settles_rad = holds_an_angle(flight) ? flight::settle_point_rad(row, flight) : std::nullopt;
  const double error_rad = roll_rad - settles_rad.value_or(roll_rad);
  spells_.back().capture.add(row, settles_rad && std::isfinite(error_rad) ? std::optional{error_rad} : std::nullopt);
  if (row.truth && std::isfinite(row.truth->disturbance_rad)) {
    const double offset_rad = row.truth->disturbance_rad;
    keep_farthest_from_zero(largest_offset_rad_, offset_rad);
    least_offset_rad_ = std::min(least_offset_rad_.value_or(offset_rad), offset_rad);
    most_offset_rad_ = std::max(most_offset_rad_.value_or(offset_rad), offset_rad);
  }
  judge_saturation(row);
  oscillation_.add(row);
}

void RunningFigures::judge_saturation(const flight::Row& row) {
  knows_saturation_ = knows_saturation_ && row.saturated;
  if (!row.saturated.value_or(false)) {
    saturation_.reset();
    return;
  }
  saturated_ += 1;
  if (!saturation_) {
    saturation_ = {.begin_s = row.time_s};
  }
  saturation_->end_s = row.time_s;
  if (row.truth) {
    keep_farthest_from_zero(saturation_->largest_offset_rad, row.truth->disturbance_rad);
    saturation_->truth = row.truth;
    saturation_->command_rad = row.command_rad;
  }
}

void RunningFigures::look_after_control(const flight::Row& row, const flight::Flight& flight) {
  const double rolled_rad = std::abs(roll_angle_rad(row) - end_.roll_angle_rad);
  if (!std::isfinite(rolled_rad)) {
    return;
  }
  if (!first_rolled_rad_) {
    keep_error(first_rolled_rad_, rolled_rad);
  }
  if (flight.events.apogee_s && row.time_s > *flight.events.apogee_s) {
    keep_error(rolled_beyond_rad_, rolled_rad);
    return;
  }
  keep_error(rolled_until_apogee_rad_, std::max(rolled_beyond_rad_.value_or(0.0), rolled_rad));
  rolled_beyond_rad_.reset();
}

void RunningFigures::tell_authority(Figures& f, const flight::Flight& flight) const {
  f.largest_disturbance_rad = largest_offset_rad_;
  if (!least_offset_rad_ || !flight.known.plan || f.in_still_air) {
    return;
  }
  // The margin is a roof over the offset: of all offsets between the least and the largest, one of these two has the
  // least margin.
  const double at_least = flight::authority_margin_rad(flight, *least_offset_rad_);
  const double at_most = flight::authority_margin_rad(flight, *most_offset_rad_);
  const double offset_rad = at_least < at_most ? *least_offset_rad_ : *most_offset_rad_;
  f.authority_margin_rad = std::min(at_least, at_most);
  f.authority_rad = flight::authority_rad(flight, -offset_rad);
}

void RunningFigures::tell_saturation(Figures& f, const flight::Flight& flight, const flight::Clock& clock) const {
  if (knows_saturation_) {
    f.saturated_fraction = static_cast<double>(saturated_) / static_cast<double>(controlled_);
  }
  if (!saturation_ || clock(saturation_->end_s) - clock(saturation_->begin_s) < lasting_saturation_s) {
    return;
  }
  f.at_limit_since_s = clock(saturation_->begin_s);
  f.offset_at_limit_rad = saturation_->largest_offset_rad;
  if (const std::optional<flight::Truth>& truth = saturation_->truth) {
    // What is left turns the rocket against the command. A canard that broke in flight can happen to help.
    const bool unbalanced = (truth->disturbance_rad + truth->canard_rad) * saturation_->command_rad < 0.0;
    f.offset_beyond_limit = flight.known.plan && unbalanced &&
                            flight::authority_margin_rad(flight, truth->disturbance_rad) < -same_angle_rad;
  }
}

void RunningFigures::tell_end(Figures& f, const flight::Flight& flight) const {
  if (!flight.events.control_end_s || (!flight.events.apogee_s && !flight.trajectory_end_s)) {
    return;
  }
  f.roll_after_end_rad = rolled_until_apogee_rad_;
  if (!flight.events.apogee_s) {
    return;  // the trajectory ends in the climb
  }
  f.ended_before_apogee_s = *flight.events.apogee_s - *flight.events.control_end_s;
  // A gap may have swallowed all of them: then the first behind it shows what happened.
  if (!f.roll_after_end_rad && *f.ended_before_apogee_s > 0.1) {
    f.roll_after_end_rad = first_rolled_rad_;
  }
}

bool RunningFigures::top_speed_is_known(const flight::Flight& flight, const flight::Clock& clock) const {
  const Extent speed = speed_.extent(clock);
  if (flight.tunnel) {  // the air's: at any time it may have been faster
    return speed.holes.empty() && speed.covers(flight.events.control_end_s.value_or(speed.end_s));
  }
  // A rocket accelerates, and then it slows down: at an edge of what is missing it may have been faster within.
  const double at_s = clock(largest_speed_at_s_);
  const bool begins_late =
      at_s == speed.begin_s && at_s > RunningExtent::shortest_hole_s && last_speed_m_s_ < largest_speed_m_s_;
  const bool ends_early =
      (at_s == speed.end_s && at_s > speed.begin_s) || !speed.covers(flight.events.burnout_s.value_or(speed.end_s));
  return !begins_late && !ends_early && std::ranges::none_of(speed.holes, [at_s](const Hole& hole) {
    return hole.from_s == at_s || hole.to_s == at_s;
  });
}

Figures RunningFigures::figures(const flight::Flight& flight, const flight::Clock& clock) const {
  Figures f;
  if (rows_ == 0) {
    return f;
  }
  f.final_phase = phase_;
  f.roll = roll_.extent(clock);
  f.begins_under_control = begins_under_control_;
  if (!flight.path.empty()) {
    f.max_speed_m_s = top_speed_over_ground_m_s(flight.path);
  } else if (top_speed_is_known(flight, clock)) {
    f.max_speed_m_s = largest_speed_m_s_;
  }
  if (!flight.tunnel && flight.events.apogee_s && height_.extent(clock).covers(*flight.events.apogee_s)) {
    f.apogee_m = largest_height_m_;
  }
  f.in_still_air = flight.tunnel && in_still_air_;
  f.camera_roll = camera_roll_.found();
  f.neutral = neutral_.found(clock);
  f.opening = opening_.found();
  if (controlled_ == 0) {
    return f;
  }
  f.misses_control_start = opening_.misses_start();
  if (!flight.tunnel && !f.misses_control_start) {
    f.control_start_height_m = if_finite(start_.height_m);
  }
  f.control_time_s = clock(end_.time_s) - clock(start_.time_s) - paused_s_;
  if (!f.misses_control_start) {
    f.capture = spells_.front().found(clock);
  }
  for (std::size_t i = 1; i < spells_.size(); ++i) {
    f.reopenings.push_back({clock(spells_[i].from_s), spells_[i].found(clock)});
  }
  f.command_at_end_rad = end_.command_rad;
  f.roll_turns = if_finite((turned_rad_ + (end_.roll_angle_rad - spells_.back().from_rad)) / (2.0 * std::numbers::pi));
  if (!f.in_still_air) {  // nothing holds anything there
    f.largest_hold_error_rad = hold_.largest_error_rad();
    f.mean_hold_error_rad = hold_.mean_error_rad();
    f.judged_time_s = f.largest_hold_error_rad ? std::optional{hold_.judged_time_s()} : std::nullopt;
    f.rest_error_rad = rest_.rest_error_rad();
    f.mean_reference_error_rad = rest_.mean_error_rad();
  }
  f.hold = hold_.record(clock, f.roll.usual_step_s);
  tell_authority(f, flight);
  tell_end(f, flight);
  f.oscillation = oscillation_.found(clock);
  if (flight.known.saturation) {
    tell_saturation(f, flight, clock);
  }
  return f;
}

}  // namespace fantail::report
