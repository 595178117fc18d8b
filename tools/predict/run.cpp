// SPDX-License-Identifier: MIT
#include "predict/run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "campaign/flown_run.hpp"
#include "flight/gate.hpp"
#include "predict/margins.hpp"
#include "report/figures.hpp"

namespace fantail::predict {
namespace {

constexpr double offset_rise_s = 1.7;
constexpr double clock_tolerance_s = 1e-6;

sim::Scenario with_airframe(const sim::Scenario& scenario, const TunnelStep& airframe, std::uint64_t seed) {
  sim::Scenario changed = scenario;
  changed.seed = seed;
  changed.vehicle.roll_plant.damping_m2 = airframe.damping_m2;
  changed.vehicle.roll_plant.torque_m = airframe.torque_m;
  changed.disturbance = {{0.0, airframe.offset_begin_rad}, {offset_rise_s, airframe.offset_end_rad}};
  changed.imposed_roll.reset();
  changed.wind = drawn_wind(scenario.wind, scenario.wind_spread, seed);
  return changed;
}

/// What is kept of the rows of a run, one by one.
class Track {
 public:
  /// The rows' time of a rocket that never lifts off counts from there.
  explicit Track(double zero_without_liftoff_s) : zero_s_{zero_without_liftoff_s} {}

  void add(const flight::Row& row, const flight::Flight& so_far) {
    if (so_far.events.liftoff_s && !has_lifted_off_) {
      has_lifted_off_ = true;
      zero_s_ = *so_far.events.liftoff_s;
      points_.clear();
    }
    const double next_s = track_step_s * static_cast<double>(points_.size());
    if (row.truth && row.time_s - zero_s_ >= next_s - clock_tolerance_s) {
      points_.push_back(row);
    }
    if (row.truth && row.truth->speed_m_s > top_speed_m_s_) {
      top_speed_m_s_ = row.truth->speed_m_s;
      offset_at_top_speed_rad_ = row.truth->disturbance_rad;
    }
    opening_.add(row, so_far);
    if (row.phase == core::Phase::controlling) {
      first_controlled_ = first_controlled_ ? first_controlled_ : row;
      last_controlled_ = row;
      const double speed_m_s = row.truth->speed_m_s;
      if (!(speed_m_s < std::min(first_controlled_->truth->speed_m_s, flight::slowest_held_m_s))) {
        lowest_speed_m_s_ = std::min(lowest_speed_m_s_, speed_m_s);
      }
      least_offset_rad_ = std::min(least_offset_rad_, row.truth->disturbance_rad);
      most_offset_rad_ = std::max(most_offset_rad_, row.truth->disturbance_rad);
    }
  }

  /// The offset that is harder to balance, of two alike the larger one: under control, as the flight report has it, and
  /// without any of the airframe's two.
  void keep_offset(Run& run, const flight::Flight& flight) const {
    const double one_rad = first_controlled_ ? least_offset_rad_ : run.airframe.offset_begin_rad;
    const double other_rad = first_controlled_ ? most_offset_rad_ : run.airframe.offset_end_rad;
    const double one_margin_rad = flight::authority_margin_rad(flight, one_rad);
    const double other_margin_rad = flight::authority_margin_rad(flight, other_rad);
    run.offset_rad = one_margin_rad < other_margin_rad ? one_rad : other_rad;
    run.authority_margin_rad = std::min(one_margin_rad, other_margin_rad);
  }

  [[nodiscard]] double offset_at_top_speed_rad() const { return offset_at_top_speed_rad_; }

  /// `clock`: from the rows' to the flight's.
  void keep(Run& run, const flight::Flight& flight, const flight::Clock& clock) const {
    for (const flight::Row& row : points_) {
      if (flight.events.apogee_s && clock(row.time_s) > *flight.events.apogee_s) {
        break;
      }
      run.roll_angle_rad.push_back(row.truth->roll_angle_rad);
      run.roll_rate_rad_s.push_back(row.truth->roll_rate_rad_s);
      run.reference_rad.push_back(row.phase == core::Phase::controlling ? std::optional{row.reference_rad}
                                                                        : std::nullopt);
    }
    if (!first_controlled_) {
      return;
    }
    run.opening = opening_.found(clock);
    run.lowest_speed_m_s = lowest_speed_m_s_;
    if (flight::authority_margin_rad(flight, last_controlled_->truth->disturbance_rad) > same_angle_rad) {
      flight::Row last = *last_controlled_;
      last.time_s = clock(last.time_s);
      run.settle_rad = flight::settle_point_rad(last, flight);
      run.settle_reference_rad = last.reference_rad;
    }
  }

 private:
  double zero_s_;
  bool has_lifted_off_ = false;
  dormancy::OpeningWatch opening_{false};
  std::vector<flight::Row> points_;
  std::optional<flight::Row> first_controlled_;
  std::optional<flight::Row> last_controlled_;
  double lowest_speed_m_s_ = std::numeric_limits<double>::infinity();
  double least_offset_rad_ = std::numeric_limits<double>::infinity();  // under control, as the next
  double most_offset_rad_ = -std::numeric_limits<double>::infinity();
  double top_speed_m_s_ = -1.0;
  double offset_at_top_speed_rad_ = 0.0;
};

void keep_notes(Run& run, const flight::Flight& flight, const sim::Scenario& scenario) {
  const auto is_in = [](const std::vector<std::string>& all, const std::string& one) {
    return std::ranges::find(all, one) != all.end();
  };
  for (const std::string& note : flight.notes) {
    if (!is_in(scenario.assumed, note) && !is_in(scenario.vehicle.assumed, note)) {
      run.notes.push_back(note);
    }
  }
}

std::optional<double> largest_tilt_rad(const flight::Flight& flight) {
  const auto tilt = flight.plan.run.tilt_from == core::TiltOrigin::guide ? &flight::PathPoint::tilt_from_guide_rad
                                                                         : &flight::PathPoint::tilt_rad;
  std::optional<double> largest_rad;
  const std::optional<double> end_s =
      flight.events.control_end_s ? flight.events.control_end_s : flight.events.apogee_s;
  for (const flight::PathPoint& point : flight.path) {
    if (flight.events.control_start_s && point.time_s >= *flight.events.control_start_s &&
        point.time_s <= end_s.value_or(point.time_s)) {
      largest_rad = std::max(largest_rad.value_or(0.0), point.*tilt);
    }
  }
  return largest_rad;
}

void keep_path(Run& run, const flight::Flight& flight, const sim::Scenario& scenario) {
  if (scenario.motion != sim::FlightMotion::six_dof) {
    return;
  }
  run.wind = drawn_wind(scenario.wind, scenario.wind_spread, run.seed);
  run.largest_tilt_rad = largest_tilt_rad(flight);
  if (flight.events.apogee_s) {
    const flight::PathPoint* point = flight::point_at(flight.path, *flight.events.apogee_s);
    run.drift_m = point != nullptr ? std::optional{flight::distance_m(*point)} : std::nullopt;
  }
}

/// Also where something else ended the wait for a height that the rocket does not reach.
bool gate_stays_closed(const flight::Flight& flight, const std::optional<double>& apogee_m) {
  if (flight.phase_changes.empty() || flight.events.control_start_s) {
    return false;
  }
  const auto gate_m = flight::gate_height_m(flight);
  const bool is_above_apogee = flight.events.dormant_s && gate_m && apogee_m && *apogee_m < *gate_m;
  return is_above_apogee || flight.phase_changes.back().reason == core::PhaseReason::gate_never_opened;
}

Run run_of(const flight::Flight& flight, const report::Figures& figures, const report::Verdict& verdict,
           const sim::Scenario& scenario, const TunnelStep& airframe, const Track& track) {
  Run run;
  run.seed = flight.seed.value_or(0);
  run.airframe = airframe;
  track.keep_offset(run, flight);
  run.outcome = verdict.outcome;
  run.verdict = verdict.text;
  run.ended_early = verdict.ended_early;
  run.ended_by_tilt = verdict.ended_by_tilt;
  run.allowed_tilt_end_s = verdict.allowed_tilt_end_s;
  run.begun_on_guide_s = verdict.begun_on_guide_s;
  run.gate_stays_closed = gate_stays_closed(flight, figures.apogee_m);
  keep_notes(run, flight, scenario);
  run.largest_hold_error_rad = figures.largest_hold_error_rad;
  run.saturated_share = figures.saturated_fraction;
  run.top_speed_m_s = figures.max_speed_m_s.value_or(0.0);
  run.extremes = flight.extremes;
  run.apogee_m = figures.apogee_m;
  if (run.authority_margin_rad < 0.0) {
    const double offset_rad = track.offset_at_top_speed_rad();
    run.spin_rate_rad_s =
        spin_rate_rad_s(airframe, offset_rad, canard_reach(scenario, offset_rad).angle_rad, run.top_speed_m_s);
  }
  keep_path(run, flight, scenario);
  return run;
}

}  // namespace

double offset_rad(const TunnelStep& airframe, double after_liftoff_s) {
  return std::lerp(airframe.offset_begin_rad, airframe.offset_end_rad,
                   std::clamp(after_liftoff_s / offset_rise_s, 0.0, 1.0));
}

std::optional<double> spin_rate_rad_s(const TunnelStep& airframe, double offset_rad, double limit_rad,
                                      double speed_m_s) {
  if (std::abs(offset_rad) <= limit_rad + same_angle_rad) {
    return std::nullopt;
  }
  const double left_rad = offset_rad - std::copysign(1.0, offset_rad) * limit_rad;  // below zero: they add to it
  return speed_m_s * airframe.torque_m * left_rad / airframe.damping_m2;
}

std::vector<std::string> fields_not_drawn(const std::vector<campaign::Spread>& spreads) {
  std::vector<std::string> names;
  for (const campaign::Spread& spread : spreads) {
    std::ranges::transform(spread.fields, std::back_inserter(names), &input::NumberField::name);
  }
  std::erase_if(names, [](const std::string& name) {
    return name == "aerodynamics.damping_m2" || name == "aerodynamics.torque_m" || name.starts_with("disturbance.");
  });
  return names;
}

flight::Flight fly_airframe(const sim::Scenario& scenario, const TunnelStep& airframe, std::uint64_t seed,
                            fly::Log log) {
  return fly::fly_scenario(with_airframe(scenario, airframe, seed), {}, {}, log);
}

Run fly_run(const sim::Scenario& scenario, const TunnelStep& airframe, std::uint64_t seed) {
  Track track{scenario.pad_time_s};
  const campaign::JudgedFlight judged =
      campaign::fly_and_judge(with_airframe(scenario, airframe, seed),
                              [&](const flight::Row& row, const flight::Flight& so_far) { track.add(row, so_far); });
  Run run = run_of(judged.flight, judged.figures, judged.verdict, scenario, airframe, track);
  track.keep(run, judged.flight, judged.flight.clock);
  return run;
}

Run run_of(const flight::Flight& flight, const sim::Scenario& scenario, const TunnelStep& airframe) {
  const report::Figures figures = report::figures(flight);
  Track track{0.0};
  for (const flight::Row& row : flight.rows) {
    track.add(row, flight);
  }
  Run run = run_of(flight, figures, report::verdict(flight, figures), scenario, airframe, track);
  track.keep(run, flight, {});
  return run;
}

}  // namespace fantail::predict
