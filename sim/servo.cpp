// SPDX-License-Identifier: MIT
#include "sim/servo.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace fantail::sim {
namespace {

constexpr double shortest_pulse_us = 500.0;
constexpr double longest_pulse_us = 2500.0;

// Written so that a NaN is refused too.
void require(bool allowed, const char* what) {
  if (!allowed) {
    throw std::invalid_argument{std::string{"servo: "} + what};
  }
}

/// Of e^-xt over t from 0 to 1; x of either sign, and no further below zero than an angle that runs to its stop needs.
double mean_of_decay(double x) {
  constexpr double same = 1e-4;
  constexpr double farthest = -30.0;
  if (x > same) {
    return settling(x).gain / x;
  }
  const double grows = -std::max(x, farthest);
  return grows < same ? 1.0 + 0.5 * grows : (exponential(grows) - 1.0) / grows;
}

}  // namespace

ServoParameters one_of_the_spread(const ServoParameters& typical, const ServoSpread& spread, Random& random) {
  const auto even = [&random] { return 2.0 * random.uniform() - 1.0; };
  const auto factor = [&] { return 1.0 + spread.share * even(); };
  ServoParameters one = typical;
  one.lag_s = std::clamp(typical.lag_s * factor(), shortest_lag_s, longest_lag_s);
  one.delay_s = std::min(typical.delay_s * factor(), longest_delay_s);
  one.rate_limit_rad_s = typical.rate_limit_rad_s * factor();
  one.backlash_rad = typical.backlash_rad * factor();
  one.centre_rad = std::clamp(typical.centre_rad + spread.centre_rad * even(), -typical.stop_rad, typical.stop_rad);
  return one;
}

Servo::Servo(const ServoParameters& parameters)
    : parameters_{parameters},
      lag_reach_rad_{parameters.rate_limit_rad_s * parameters.lag_s},
      half_play_rad_{0.5 * parameters.backlash_rad},
      gear_stop_rad_{parameters.stop_rad + half_play_rad_},
      gear_rad_{parameters.centre_rad},
      horn_rad_{parameters.centre_rad},
      mean_horn_rad_{parameters.centre_rad} {
  require(parameters.lag_s >= shortest_lag_s && parameters.lag_s <= longest_lag_s, "lag_s must be 0.0005 to 1");
  require(parameters.delay_s >= 0.0 && parameters.delay_s <= longest_delay_s, "delay_s must be 0 to 0.05");
  require(parameters.frame_period_s >= 0.001, "frame_period_s must be at least 0.001");
  require(parameters.rate_limit_rad_s > 0.0, "rate_limit_rad_s must be above 0");
  require(parameters.stop_rad > 0.0, "stop_rad must be above 0");
  require(parameters.backlash_rad >= 0.0, "backlash_rad must not be below 0");
  require(std::isfinite(parameters.pulse_centre_us), "pulse_centre_us must be finite");
  require(std::abs(parameters.pulse_per_degree_us) > 0.0, "pulse_per_degree_us must not be 0");
  require(std::abs(parameters.centre_rad) <= parameters.stop_rad, "centre_rad must be within the stop");
  require(!parameters.torque_n_m || *parameters.torque_n_m > 0.0, "torque_n_m must be above 0");
  set_pace(1.0);
}

void Servo::fail(ServoFault fault, std::optional<double> fault_angle_rad) {
  require(!fault_angle_rad || std::isfinite(*fault_angle_rad), "the angle of a fault must be finite");
  next_event_s_ = at_once;
  if (fault != fault_) {
    if (fault_ == ServoFault::slipping) {
      gear_rad_ = horn_rad_ = angle_rad();
      mean_horn_rad_ = mean_angle_rad();
      slip_from_rad_ = 0.0;
      grip_ = 1.0;
    }
    if (fault == ServoFault::slipping) {
      slip_from_rad_ = horn_rad_;
      grip_ = slipping_grip;
    }
    set_pace(fault == ServoFault::slow ? slow_times : 1.0);
    fault_ = fault;
  }
  double trim_error_rad = 0.0;
  if (fault == ServoFault::wrong_trim) {
    trim_error_rad = fault_angle_rad.value_or(usual_wrong_trim_rad);
    shift_shaft(trim_error_rad - trim_error_rad_);
  } else if (fault == ServoFault::stuck && fault_angle_rad) {
    shift_shaft(*fault_angle_rad - horn_rad_);
  }
  trim_error_rad_ = trim_error_rad;
  aim();
}

void Servo::set_pace(double times_slower) {
  per_lag_s_ = 1.0 / (times_slower * parameters_.lag_s);
  rate_limit_rad_s_ = parameters_.rate_limit_rad_s / times_slower;
  whole_step_ = {};  // made anew by the next step
}

// Gear and horn together, so that the play between them stays as it was.
void Servo::shift_shaft(double by_rad) {
  horn_rad_ = std::clamp(horn_rad_ + by_rad, -parameters_.stop_rad, parameters_.stop_rad);
  turn_to(gear_rad_ + by_rad);
}

void Servo::aim() {
  if (!asked_rad_) {
    goal_rad_.reset();
    return;
  }
  const double from_centre_rad = fault_ == ServoFault::reversed ? -*asked_rad_ : *asked_rad_;
  goal_rad_.emplace(parameters_.centre_rad + trim_error_rad_ + from_centre_rad);
}

// The pulse is the same for the whole step, so only the first frame in it can change what the servo is told.
void Servo::latch(double t_s, double end_s, const std::optional<double>& pulse_us) {
  if (next_frame_s_ < t_s - same_time_s) {
    frame_ = std::ceil((t_s - same_time_s) / parameters_.frame_period_s);
    next_frame_s_ = frame_ * parameters_.frame_period_s;
    if (next_frame_s_ >= end_s) {
      return;
    }
  }
  const double frame_s = next_frame_s_;
  while (next_frame_s_ < end_s) {
    frame_ += 1.0;
    next_frame_s_ = frame_ * parameters_.frame_period_s;
  }
  if (pulse_us == latched_us_ || (pulse_us && !(*pulse_us >= shortest_pulse_us && *pulse_us <= longest_pulse_us))) {
    return;
  }
  // Value and flag one by one: to copy an optional whose two halves have just been written, the processor waits for
  // both of them to reach the cache.
  Command& command = queue_[(first_ + waiting_) % queue_.size()];
  command.arrival_s = frame_s + parameters_.delay_s;
  if (pulse_us) {
    latched_us_.emplace(*pulse_us);
    command.asked_rad.emplace((*pulse_us - parameters_.pulse_centre_us) *
                              (radians_per_degree / parameters_.pulse_per_degree_us));
  } else {
    latched_us_.reset();
    command.asked_rad.reset();
  }
  ++waiting_;
}

void Servo::step_in_pieces(double t_s, double end_s) {
  double now_s = t_s;
  double travelled = 0.0;
  while (waiting_ > 0 && queue_[first_].arrival_s < end_s - same_time_s) {
    const Command& command = queue_[first_];
    if (command.arrival_s > now_s) {
      travelled += move(interval(command.arrival_s - now_s));
      now_s = command.arrival_s;
    }
    asked_rad_ = command.asked_rad;
    aim();
    first_ = (first_ + 1) % queue_.size();
    --waiting_;
  }
  travelled += move(now_s == t_s ? whole_step_ : interval(end_s - now_s));
  mean_horn_rad_ = travelled / (end_s - t_s);
}

// Each of these moves for one piece of a step and returns the integral of the horn's angle over it.
double Servo::move(const Interval& piece) {
  const double before = horn_rad_;
  switch (fault_) {
    case ServoFault::none:
    case ServoFault::slipping:
    case ServoFault::reversed:
    case ServoFault::slow:
    case ServoFault::wrong_trim:
      if (load_) {
        return drive_loaded(piece);
      }
      return goal_rad_ ? drive(piece, *goal_rad_, rate_limit_rad_s_, lag_reach_rad_) : before * piece.duration_s;
    case ServoFault::hardover: return load_ ? drive_loaded(piece) : turn_at_speed(rate_limit_rad_s_, piece.duration_s);
    case ServoFault::dead:
      gear_rad_ = horn_rad_ = before - before * piece.settling.gain;
      return piece.duration_s * (before + piece.settling.weight * (horn_rad_ - before));
    case ServoFault::stuck: break;
  }
  return before * piece.duration_s;
}

double Servo::drive(const Interval& piece, double goal_rad, double limit_rad_s, double reach_rad) {
  const double distance = goal_rad - gear_rad_;
  const double excess = std::abs(distance) - reach_rad;
  if (excess <= 0.0) {
    const double before = horn_rad_;
    turn_to(gear_rad_ + distance * piece.settling.gain);
    return piece.duration_s * (before + piece.settling.weight * (horn_rad_ - before));
  }
  const double limited_s = excess / limit_rad_s;
  const double speed_rad_s = distance > 0.0 ? limit_rad_s : -limit_rad_s;
  if (limited_s >= piece.duration_s) {
    return turn_at_speed(speed_rad_s, piece.duration_s);
  }
  const Interval rest = interval(piece.duration_s - limited_s);
  const double limited = turn_at_speed(speed_rad_s, limited_s);
  const double before = horn_rad_;
  turn_to(gear_rad_ + (goal_rad - gear_rad_) * rest.settling.gain);
  return limited + rest.duration_s * (before + rest.settling.weight * (horn_rad_ - before));
}

double Servo::drive_loaded(const Interval& piece) {
  constexpr double far_away_rad = 1e6;  // a hardover never arrives
  const double goal_rad = fault_ == ServoFault::hardover ? far_away_rad : goal_rad_.value_or(gear_rad_);
  const double torque_n_m = *parameters_.torque_n_m;
  const double load = load_->moment_n_m(angle_rad()) / torque_n_m;
  const auto [least_rad_s, most_rad_s] = speeds_under_load(rate_limit_rad_s_, load);
  // A speed that the load alone sets changes on the way with the load, as an exponential.
  const double fading = mean_of_decay(rate_limit_rad_s_ * load_->stiffness_n_m_per_rad / torque_n_m * piece.duration_s);
  const double distance = goal_rad - gear_rad_;
  const double own_rad_s = std::clamp(distance * per_lag_s_, -rate_limit_rad_s_, rate_limit_rad_s_);
  if (least_rad_s > 0.0) {
    return turn_at_speed(std::max(own_rad_s, fading * least_rad_s), piece.duration_s);
  }
  if (most_rad_s < 0.0) {
    return turn_at_speed(std::min(own_rad_s, fading * most_rad_s), piece.duration_s);
  }
  if (distance == 0.0) {
    return horn_rad_ * piece.duration_s;
  }
  // Where there is no load yet, the air makes one against a canard that it turns back.
  const bool is_against = load == 0.0 ? load_->stiffness_n_m_per_rad > 0.0 : distance * load < 0.0;
  const double limit_rad_s = (distance > 0.0 ? most_rad_s : -least_rad_s) * (is_against ? fading : 1.0);
  // The load is exactly its torque: it stays. A zero below zero would make the time to the goal minus infinity.
  if (limit_rad_s == 0.0) {
    return horn_rad_ * piece.duration_s;
  }
  return drive(piece, goal_rad, limit_rad_s, limit_rad_s / per_lag_s_);
}

double Servo::turn_at_speed(double speed_rad_s, double duration_s) {
  const double before = horn_rad_;
  turn_to(gear_rad_ + speed_rad_s * duration_s);
  return duration_s * 0.5 * (before + horn_rad_);
}

}  // namespace fantail::sim
