// SPDX-License-Identifier: MIT
#pragma once

#include "core/autopilot.hpp"
#include "core/roll_reference.hpp"
#include "proof.hpp"

// For proofs of Autopilot::step: bodies, in the place of those of its parts, that give any answer at all. What is
// proved with them holds for the real parts, whose answers are some of these; the folder any_parts has those that a
// header defines. Real remain Autopilot and FlightPhase. The mixer only notes what it is asked for: what it makes of
// that is canard_mixer.cpp's.

namespace fantail::proof {

inline std::optional<core::Angle> any_contribution() {
  return nondet_bool() ? std::optional<core::Angle>{any_angle()} : std::optional<core::Angle>{};
}

/// What the mixer was asked for, in the one call of a step.
struct Asked {
  int calls = 0;
  core::Angle roll_command{};
  bool requested = false;
};
inline Asked asked;

/// What the gate answers.
inline bool gate_is_open = true;

}  // namespace fantail::proof

namespace fantail::core {

LaunchDetector::LaunchDetector(const LaunchDetectionPlan& plan, Microseconds stale_time)
    : plan_{plan}, stale_time_{stale_time}, channels_{Channel{1.0F}, Channel{1.0F}} {}
void LaunchDetector::reset() {}
DetectionState LaunchDetector::update(Microseconds, const std::array<AccelerometerSample, 2>&) {
  return proof::any_of<DetectionState>(5);
}
bool LaunchDetector::agrees(Microseconds, const std::array<AccelerometerSample, 2>&) { return nondet_bool(); }

CanardMonitor::CanardMonitor(const MonitorPlan& monitor, const CanardsPlan&) : plan_{monitor}, servo_lag_s_{1.0F} {}
void CanardMonitor::bridge() {}
const CanardVerdicts& CanardMonitor::update(Microseconds, const CanardCommands&, const EncoderAngles&) {
  for (std::size_t i = 0; i < canard_count; ++i) {
    verdicts_[i] = proof::any_of<CanardVerdict>(canard_verdicts);
  }
  return verdicts_;
}

CanardMixer::CanardMixer(const CanardsPlan& plan, Angle) : first_motion_rate_rad_s_{plan.first_motion_rate_rad_s} {}
void CanardMixer::mix(Microseconds, Angle roll_command, const std::optional<std::array<Angle, canard_count>>& requested,
                      const EncoderAngles&, CanardCommands&) {
  proof::asked.calls += 1;
  proof::asked.roll_command = roll_command;
  proof::asked.requested = requested.has_value();
}
std::optional<Angle> CanardMixer::canard_angle(const EncoderAngles&) const { return proof::any_contribution(); }
std::optional<Angle> CanardMixer::contribution(std::size_t, const std::optional<Angle>&) const {
  return proof::any_contribution();
}

void BarometricHeight::update(const Inputs&, bool, const Motion&) {
  state_ = proof::any_of<BarometerState>(barometer_states);
  least_height_m_ = nondet_bool() ? std::optional{nondet_float()} : std::nullopt;
  height_m_ = nondet_float();
  vertical_speed_m_s_ = nondet_float();
}

void DormancyGate::update(Microseconds, const Motion&, bool, std::optional<float>) {}
bool DormancyGate::is_open() const { return proof::gate_is_open; }

Capture::Capture(const FlightPlan& plan) : observer_{plan.offset, plan.roll_model} {}
void Capture::watch(const Motion&) { offset_ = proof::any_contribution(); }
Angle Capture::begin(const Motion&, Angle) {
  offset_ = proof::any_contribution();
  return proof::any_angle();
}

Chirp::Chirp(const ExcitationPlan& plan) : plan_{plan} {}
Angle Chirp::update(Microseconds) { return proof::any_angle(); }
GainSchedule::GainSchedule(const GainSchedulePlan&) : is_there_{false} {}
Angle roll_reference(const ReferencePlan&, Microseconds) { return proof::any_angle(); }

}  // namespace fantail::core
