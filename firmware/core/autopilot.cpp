// SPDX-License-Identifier: MIT
#include "core/autopilot.hpp"

#include <algorithm>
#include <limits>

#include "core/pd_controller.hpp"
#include "core/per_canard.hpp"
#include "core/roll_reference.hpp"

namespace fantail::core {
namespace {

// Five missed ticks: what the estimator may bridge. A clock that stands still or runs backwards is worse.
constexpr Microseconds longest_tick{5'000};

constexpr std::optional<std::array<Angle, canard_count>> no_request;

}  // namespace

Autopilot::Autopilot(const FlightPlan& plan)
    : barometric_height_{plan.sensors, plan.dormancy},
      dormancy_gate_{plan.dormancy},
      capture_{plan},
      controller_{plan.controller},
      gain_schedule_{plan.gain_schedule},
      adapts_{plan.gain_schedule.speeds_count > 0 || plan.offset.rejection != OffsetRejection::none},
      reference_{plan.reference},
      overrun_limit_{plan.run.overrun_limit},
      flight_phase_{plan.run, plan.guide, plan.motion},
      is_gated_{plan.dormancy.until != DormantUntil::guide},
      captures_{plan.controller.entry == ControlEntry::capture},
      has_barometer_{plan.sensors.barometer != BarometerUse::none},
      chirp_{plan.excitation},
      offset_estimator_{plan},
      canard_mixer_{plan.canards, plan.controller.canard_limit},
      shares_{plan.run.canard_fault == CanardFaultPolicy::share},
      canard_sharing_{plan.controller.canard_limit},
      motion_estimator_{plan.motion, plan.sensors, plan.run.tilt_from},
      launch_detector_{plan.launch_detection, plan.motion.stale_time},
      canard_monitor_{plan.monitor, plan.canards} {}

// Every signal of the record is written in every step: nothing of the last one stays.
const TickRecord& Autopilot::step(const Inputs& inputs) {
  TickRecord& record = record_;
  record.time = inputs.time;
  record.timing_fault = watch_clock(inputs.time);
  record.overruns = overruns_;
  record.encoders = inputs.encoders;

  motion_estimator_.update(inputs);
  motion_estimator_.motion(inputs.time, record.motion);
  if (motion_estimator_.votes()) {
    record.gyro_vote = motion_estimator_.gyro_vote();  // else empty for ever
  }
  record.detection = flight_phase_.listens_for_launch() ? launch_detector_.update(inputs.time, inputs.accelerometers)
                                                        : DetectionState::quiet;

  const Phase before = flight_phase_.phase();
  const bool asks_both = before == Phase::launched || before == Phase::dormant;
  const bool agree = !asks_both || launch_detector_.agrees(inputs.time, inputs.accelerometers);
  watch_height(inputs, before, agree);
  const bool changed = flight_phase_.update({.time = inputs.time,
                                             .arm_switch_closed = inputs.arm_switch_closed,
                                             .arm_command = inputs.arm_command,
                                             .start_command = inputs.start_command,
                                             .launch_detected = record.detection == DetectionState::detected,
                                             .accelerometers_agree = agree,
                                             .timing_fault = record.timing_fault,
                                             .canard_fault = canard_fault_,
                                             .gate_is_open = !is_gated_ || dormancy_gate_.is_open(),
                                             .abort = inputs.abort,
                                             .climbs = has_barometer_ && barometric_height_.climbs(record.motion)},
                                            record.motion);
  record.phase = flight_phase_.phase();
  record.reason = flight_phase_.reason();
  if (changed) {
    enter_phase(inputs.time, before, record.phase);
    motion_estimator_.motion(inputs.time, record.motion);
  }
  if (has_barometer_) {
    barometric_height_.correct(record.motion);
  }

  Angle asked_of_each;
  if (record.phase == Phase::controlling) {
    // Always there, except in a state that a damaged log made up.
    asked_of_each = control(inputs.time - flight_phase_.control_start().value_or(inputs.time));
  } else {
    // Meets PHS-1, DOR-1.
    record.reference = record.excitation = record.offset_estimate = Angle{};
    if (captures_ && record.phase == Phase::dormant) {
      capture_.watch(record.motion);
      record.offset_estimate = capture_.offset().value_or(Angle{});
    }
    stay_neutral(CommandStatus::outside_control);
  }

  // Meets BEN-1.
  canard_mixer_.mix(inputs.time, asked_of_each, record.phase == Phase::safe ? inputs.canard_request : no_request,
                    inputs.encoders, record.canards);
  record.canard_angle = canard_mixer_.canard_angle(inputs.encoders);

  record.verdicts = canard_monitor_.update(inputs.time, record.canards, inputs.encoders);
  canard_fault_ = !all_healthy(record.verdicts);
  return record;
}

// Meets MEM-3.
void Autopilot::resume(const Inputs& first) {
  motion_estimator_.bridge(first);
  dormancy_gate_.interrupt();
  capture_.interrupt();
  barometric_height_.interrupt();
  canard_monitor_.bridge();
  offset_estimator_.interrupt();
  last_time_.reset();
}

std::span<const std::byte> Autopilot::flight_memory() const {
  const void* begin = &controller_;
  if (has_barometer_) {
    begin = &barometric_height_;
  } else if (is_gated_ || captures_) {
    begin = &dormancy_gate_;
  }
  return {static_cast<const std::byte*>(begin),
          static_cast<const std::byte*>(motion_estimator_.end_of_flight_memory())};
}

Angle Autopilot::control(Microseconds since_control_start) {
  TickRecord& record = record_;
  const bool shares = shares_work();
  record.reference = roll_reference(reference_, since_control_start) + turns_;
  record.excitation = chirp_.update(since_control_start);
  if (record.motion.gyro == SensorState::lost) {
    record.offset_estimate = offset_estimator_.estimate();
    // Meets SEN-1.
    offset_estimator_.interrupt();
    stay_neutral(CommandStatus::gyro_lost);
    return shares ? canard_sharing_.asked_of_each(Angle{}) : Angle{};
  }
  // A law that does not adapt has no estimate but the zero that stands in the record.
  RollCommand roll = adapts_ ? adapted_command()
                             : pd_controller(controller_, record.reference, record.motion.roll_angle,
                                             record.motion.roll_rate_rad_s, record.excitation);
  Angle asked_of_each = roll.command;
  if (shares) {
    canard_sharing_.limit(roll);
    asked_of_each = canard_sharing_.asked_of_each(roll.command);
  }
  if (adapts_) {
    offset_estimator_.remember(roll);
  }
  // uncovered: no finite plan and no state that the estimator keeps gives a command that is not finite
  record.command_status = roll.finite ? CommandStatus::controlling : CommandStatus::not_finite;
  record.unclamped_command = roll.unclamped;
  record.command = shares ? clamp(roll.command, controller_.canard_limit) : roll.command;
  record.saturated = roll.saturated;
  return asked_of_each;
}

// The verdicts of the tick before: a monitor can judge a command only after it was given.
bool Autopilot::shares_work() {
  if (!shares_ || (!canard_fault_ && !canard_sharing_.is_active())) {
    return false;
  }
  canard_sharing_.update(canard_monitor_.verdicts(), per_canard([this](std::size_t i) {
                           return canard_mixer_.contribution(i, record_.encoders[i]);
                         }));
  return canard_sharing_.is_active();
}

RollCommand Autopilot::adapted_command() {
  TickRecord& record = record_;
  const Motion& motion = record.motion;
  const float factor = gain_schedule_.factor(motion.speed_m_s, motion.speed_is_lower_bound);
  offset_estimator_.update(motion, record.reference - motion.roll_angle, factor, canard_sharing_.reach());
  record.offset_estimate = offset_estimator_.estimate();
  return pd_controller(controller_, record.reference, motion.roll_angle, motion.roll_rate_rad_s, record.excitation,
                       {factor, record.offset_estimate});
}

void Autopilot::stay_neutral(CommandStatus why) {
  record_.command_status = why;
  record_.unclamped_command = record_.command = Angle{};
  record_.saturated = false;
}

void Autopilot::enter_phase(Microseconds time, Phase from, Phase to) {
  if (from == Phase::armed) {
    overruns_before_flight_ = overruns_;
  }
  if (to == Phase::launched) {
    motion_estimator_.begin_flight(time);
    dormancy_gate_.reset();
    barometric_height_.begin_flight();
  } else if (from == Phase::launched && is_flight(to)) {
    motion_estimator_.leave_guide();
  } else if (to == Phase::controlling && from == Phase::armed) {
    motion_estimator_.begin_tunnel_run(time);
  } else if (to == Phase::armed) {
    if (from == Phase::launched) {
      motion_estimator_.return_to_pad();
    }
    launch_detector_.reset();
  }
  if (to == Phase::controlling) {
    begin_control(motion_estimator_.motion(time), time);
  } else if (from == Phase::controlling) {
    offset_estimator_.interrupt();
  }
}

// Gate and phase are asked about the motion as the accelerometer has it.
void Autopilot::watch_height(const Inputs& inputs, Phase before, bool agree) {
  TickRecord& record = record_;
  std::optional<float> by_barometer;
  if (has_barometer_) {
    barometric_height_.update(inputs, is_flight(before) || before == Phase::finished, record.motion);
    record.barometer_state = barometric_height_.state();
    by_barometer = barometric_height_.least_height_m();
  }
  if (is_gated_ && is_flight(before)) {
    dormancy_gate_.update(inputs.time, record.motion, agree || before == Phase::launched, by_barometer);
  }
}

// A law that begins as published has no turns and no estimate to begin with.
void Autopilot::begin_control(const Motion& motion, Microseconds time) {
  if (!captures_) {
    return;
  }
  record_.offset_estimate = Angle{};  // what Dormant showed: a law that rejects no offset has none
  turns_ = capture_.begin(motion, roll_reference(reference_, time - flight_phase_.control_start().value_or(time)));
  if (capture_.offset()) {
    offset_estimator_.begin(*capture_.offset());
  }
}

// From the times alone, so that a replay counts the same. A tick that is late by half a period at most has come.
bool Autopilot::watch_clock(Microseconds time) {
  const Microseconds elapsed = last_time_ ? time - *last_time_ : tick_period;
  last_time_ = time;
  if (elapsed > tick_period * 3 / 2) {
    const std::int64_t missed = (elapsed - Microseconds{1} + tick_period / 2) / tick_period - 1;
    const std::int64_t most = std::numeric_limits<std::uint32_t>::max() - overruns_;
    overruns_ += static_cast<std::uint32_t>(std::min(missed, most));
  }
  const bool flies = is_flight(flight_phase_.phase());
  // Meets TIM-1, TIM-3.
  // Each one spoils rate and angle a little, and a loop that keeps failing is not the one that was tested.
  const bool too_many = flies && overruns_ - overruns_before_flight_ > overrun_limit_;
  return too_many || elapsed <= Microseconds{0} || elapsed > longest_tick;
}

}  // namespace fantail::core
