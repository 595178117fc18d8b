// SPDX-License-Identifier: MIT
#include "flight/flight.hpp"

#include <algorithm>
#include <cmath>

#include "core/flight_plan_members.hpp"
#include "core/height_error.hpp"
#include "flight/barometer.hpp"

namespace fantail::flight {
namespace {

std::optional<double> finite_angle(const std::optional<core::Angle>& angle) {
  if (!angle || !std::isfinite(angle->radians())) {
    return std::nullopt;
  }
  return static_cast<double>(angle->radians());
}

/// What the law calls a timing fault is mostly a processor that missed ticks.
void note_missed_ticks(Flight& flight, double time_s) {
  constexpr double more_than_a_tick_s = 1.5e-3;
  if (flight.last_tick_s && time_s - *flight.last_tick_s > more_than_a_tick_s) {
    flight.outages.push_back({.from_s = *flight.last_tick_s, .to_s = time_s, .cause = {}, .resumed = false});
  }
}

void note_phase(Flight& flight, const core::TickRecord& record, double time_s) {
  const core::Phase before = flight.phase_changes.empty() ? core::Phase::safe : flight.phase_changes.back().phase;
  const bool has_new_reason = !flight.phase_changes.empty() && flight.phase_changes.back().reason &&
                              flight.phase_changes.back().reason != record.reason;
  if (record.phase == before && !has_new_reason) {
    return;
  }
  flight.phase_changes.push_back({time_s, record.phase, record.reason});
  if (core::is_flight(record.phase)) {
    flight.gyro_bias_rad_s = record.motion.gyro_bias_rad_s;
  }
  if (record.reason == core::PhaseReason::timing_fault ||
      record.reason == core::PhaseReason::timing_fault_before_control) {
    note_missed_ticks(flight, time_s);
  }
  if (before == core::Phase::controlling && record.phase == core::Phase::safe) {
    flight.events.control_end_s = time_s;  // a reset after which nothing was resumed
  }
  note_phase_event(flight.events, before, record.phase, time_s);
}

void note_canards(Flight& flight, const core::TickRecord& record, double time_s) {
  auto& changes = flight.canard_verdict_changes;
  const auto healthy = [](core::CanardVerdict verdict) { return verdict == core::CanardVerdict::healthy; };
  if (changes.empty() && std::ranges::all_of(record.verdicts, healthy)) {
    return;  // as in nearly every tick of nearly every flight
  }
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const auto last = std::find_if(changes.rbegin(), changes.rend(), [i](const auto& c) { return c.canard == i; });
    const core::CanardVerdict before = last == changes.rend() ? core::CanardVerdict::healthy : last->verdict;
    if (record.verdicts[i] != before) {
      changes.push_back({time_s, i, record.verdicts[i]});
    }
  }
}

void note_unmeasured(Flight& flight, const core::TickRecord& record, double time_s) {
  constexpr double tick_s = 1e-3;
  Unmeasured& u = flight.unmeasured;
  const bool flies = core::is_flight(record.phase);
  const auto add = [time_s](std::optional<double>& from_s, double& for_s) {
    from_s = from_s.value_or(time_s);
    for_s += tick_s;
  };
  if (flies && record.motion.rate_is_lower_bound) {
    add(u.spin_from_s, u.spin_for_s);
    u.spin_rad_s = static_cast<double>(record.motion.roll_rate_rad_s);
  }
  if (record.command_status == core::CommandStatus::gyro_lost) {
    add(u.silent_from_s, u.silent_for_s);
  }
  if (flies && record.motion.speed_is_lower_bound) {
    u.speed_bound_from_s = u.speed_bound_from_s.value_or(time_s);
  }
}

}  // namespace

std::optional<double>* event_of(Events& events, core::Phase phase) {
  switch (phase) {
    case core::Phase::launched: return &events.detected_s;
    case core::Phase::dormant: return &events.dormant_s;
    case core::Phase::controlling: return &events.control_start_s;
    case core::Phase::finished: return &events.control_end_s;
    case core::Phase::safe:
    case core::Phase::armed: break;
  }
  return nullptr;
}

// A gate that closes again ends control until it opens; only the first time is a beginning.
void note_phase_event(Events& events, core::Phase from, core::Phase to, double time_s) {
  using enum core::Phase;
  std::optional<double>* const event = event_of(events, to);
  if (event == nullptr) {
    return;
  }
  const bool goes_on = events.control_start_s && (from == controlling || from == dormant);
  if (goes_on && to == dormant) {
    events.control_end_s = time_s;
  } else if (goes_on && to == controlling) {
    events.control_end_s.reset();
  } else if (to != finished || from != dormant || !events.control_end_s) {
    *event = time_s;
  }
}

namespace {

/// With no smaller an error of the accelerometer than plans state where nobody measured it, whatever this plan states.
std::optional<double> height_error_m(const core::TickRecord& record) {
  static const core::DormancyPlan usual = core::default_plan().dormancy;
  const bool is_under_way = core::is_flight(record.phase) || record.phase == core::Phase::finished;
  if (record.barometer_state == core::BarometerState::used || !is_under_way) {
    return std::nullopt;
  }
  return static_cast<double>(core::motion_error(usual, record.time, record.motion).height_m);
}

void fill(Row& r, const core::TickRecord& record, double time_s) {
  r.time_s = time_s;
  r.phase = record.phase;
  r.roll_angle_rad = static_cast<double>(record.motion.roll_angle.radians());
  r.roll_rate_rad_s = static_cast<double>(record.motion.roll_rate_rad_s);
  r.reference_rad = static_cast<double>(record.reference.radians());
  r.excitation_rad = static_cast<double>(record.excitation.radians());
  r.offset_estimate_rad = static_cast<double>(record.offset_estimate.radians());
  r.command_rad = static_cast<double>(record.command.radians());
  r.saturated = record.saturated;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (record.canards[i].driven) {
      r.commands_rad[i] = static_cast<double>(record.canards[i].angle.radians());
    }
    r.encoders_rad[i] = finite_angle(record.encoders[i]);
  }
  r.canard_rad = finite_angle(record.canard_angle);
  r.specific_force_m_s2 = static_cast<double>(record.motion.specific_force_m_s2.x);
  r.height_m = static_cast<double>(record.motion.height_m);
  r.speed_m_s = static_cast<double>(record.motion.speed_m_s);
  r.tilt_from_guide_rad = finite_angle(record.motion.tilt_from_guide);
  r.height_error_m = height_error_m(record);
}

}  // namespace

Row row(const core::TickRecord& record, double time_s) {
  Row r;
  fill(r, record, time_s);
  return r;
}

void note_tick(Flight& flight, const core::TickRecord& record, double time_s) {
  note_phase(flight, record, time_s);
  flight.last_tick_s = time_s;
  note_canards(flight, record, time_s);
  note_unmeasured(flight, record, time_s);
  note_barometer(flight, record, time_s);
}

void add_tick(Flight& flight, const core::TickRecord& record, double time_s, const std::optional<Truth>& truth) {
  note_tick(flight, record, time_s);
  Row& r = flight.rows.emplace_back();  // filled where it stands: a flight has megabytes of them
  fill(r, record, time_s);
  r.truth = truth;
}

void end_control_with_outage(Flight& flight) {
  for (const Outage& outage : flight.outages) {
    if (!outage.resumed && flight.events.control_start_s && flight.events.control_end_s == outage.to_s) {
      flight.events.control_end_s = outage.from_s;
      return;
    }
  }
}

void set_time_zero(Flight& flight, double zero_s) {
  flight.clock = {zero_s};
  const auto move = [clock = flight.clock](double& time_s) { time_s = clock(time_s); };
  const auto move_known = [&move](std::optional<double>& time_s) {
    if (time_s) {
      move(*time_s);
    }
  };
  for (const NamedEvent& event : named_events) {
    move_known(flight.events.*event.time_s);
  }
  Unmeasured& u = flight.unmeasured;
  for (std::optional<double>* time_s : {&u.spin_from_s, &u.silent_from_s, &u.speed_bound_from_s}) {
    move_known(*time_s);
  }
  if (flight.before_burnout) {
    BeforeBurnout& b = *flight.before_burnout;
    for (std::optional<double>* time_s : {&b.turned_over_s, &b.sank_s, &b.parachute_s, &b.ground_s, &b.left_again_s}) {
      move_known(*time_s);
    }
  }
  if (flight.imposed_roll) {
    move(flight.imposed_roll->time_s);
  }
  move_known(flight.trajectory_end_s);
  if (flight.airframe) {
    std::map<double, double> course;
    for (const auto& [time_s, inertia_kg_m2] : flight.airframe->roll_inertia_course) {
      course[flight.clock(time_s)] = inertia_kg_m2;
    }
    flight.airframe->roll_inertia_course = course;
  }
  for (Outage& outage : flight.outages) {
    move(outage.from_s);
    move_known(outage.to_s);
  }
  std::ranges::for_each(flight.phase_changes, [&](auto& change) { move(change.time_s); });
  std::ranges::for_each(flight.canard_verdict_changes, [&](auto& change) { move(change.time_s); });
  std::ranges::for_each(flight.barometer_spells, move, &BarometerSpell::from_s);
  std::ranges::for_each(flight.barometer_spells, move, &BarometerSpell::to_s);
  std::ranges::for_each(flight.rows, [&](auto& r) { move(r.time_s); });
  std::ranges::for_each(flight.path, [&](auto& point) { move(point.time_s); });
  std::ranges::for_each(flight.turning, [&](auto& point) { move(point.time_s); });
  std::ranges::for_each(flight.without_control, [&](auto& point) { move(point.time_s); });
  std::ranges::for_each(flight.tunnel_readings, [&](auto& reading) { move(reading.time_s); });
}

std::string_view tilt_origin(const core::FlightPlan& plan) {
  return plan.run.tilt_from == core::TiltOrigin::guide ? "the launch guide" : "the vertical";
}

double canard_limit_rad(const core::FlightPlan& plan) {
  return static_cast<double>(std::min(plan.controller.canard_limit, core::hard_canard_limit).radians());
}

double authority_rad(const Flight& flight, double sense) {
  if (flight.canard_reach) {
    return sense > 0.0 ? flight.canard_reach->highest_rad : -flight.canard_reach->lowest_rad;
  }
  const core::FlightPlan& plan = flight.plan;
  const double command_rad = std::copysign(canard_limit_rad(plan), sense);
  double sum_rad = 0.0;
  for (const core::CanardPlan& canard : plan.canards.each) {
    const double limit_rad = std::min(canard_limit_rad(plan), static_cast<double>(canard.mechanical_stop.radians()));
    const double turned = canard.direction == core::Direction::reversed ? -1.0 : 1.0;
    const auto trim_rad = static_cast<double>(canard.trim.radians());
    sum_rad += turned * (std::clamp(turned * command_rad + trim_rad, -limit_rad, limit_rad) - trim_rad);
  }
  return std::abs(sum_rad) / static_cast<double>(core::canard_count);
}

double authority_margin_rad(const Flight& flight, double offset_rad) {
  return std::min(authority_rad(flight, 1.0) + offset_rad, authority_rad(flight, -1.0) - offset_rad);
}

}  // namespace fantail::flight
