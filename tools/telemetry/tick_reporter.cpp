// SPDX-License-Identifier: MIT
#include "telemetry/tick_reporter.hpp"

#include <algorithm>

#include "avionics/can_frame.hpp"
#include "core/canard_mixer.hpp"

namespace fantail::telemetry {
namespace {

double radians(core::Angle angle) { return static_cast<double>(angle.radians()); }

std::optional<double> radians(const std::optional<core::Angle>& angle) {
  return angle ? std::optional{radians(*angle)} : std::nullopt;
}

}  // namespace

Limits limits_of(const core::FlightPlan& plan) {
  const core::CanardMixer mixer{plan.canards, plan.controller.canard_limit};
  Limits limits_rad;
  for (std::size_t i = 0; i < limits_rad.size(); ++i) {
    limits_rad[i] = radians(mixer.limit(i));
  }
  return limits_rad;
}

State state_of(const core::TickRecord& record) {
  const core::Motion& motion = record.motion;
  return {.phase = record.phase,
          .reason = record.reason,
          .command_status = record.command_status,
          .timing_fault = record.timing_fault,
          .saturated = record.saturated,
          .roll_angle_rad = radians(motion.roll_angle),
          .roll_rate_rad_s = motion.roll_rate_rad_s,
          .reference_rad = radians(record.reference),
          .excitation_rad = radians(record.excitation),
          .unclamped_command_rad = radians(record.unclamped_command),
          .command_rad = radians(record.command),
          .specific_force_m_s2 = motion.specific_force_m_s2.x,
          .height_m = motion.height_m,
          .speed_m_s = motion.speed_m_s,
          .vertical_speed_m_s = motion.vertical_speed_m_s,
          .tilt_rad = radians(motion.tilt)};
}

Canards canards_of(const core::TickRecord& record, const Limits& limits_rad) {
  Canards canards;
  canards.limit_rad = limits_rad;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const core::CanardCommand& command = record.canards[i];
    canards.command_rad[i] = command.driven ? std::optional{radians(command.angle)} : std::nullopt;
    canards.encoder_rad[i] = radians(record.encoders[i]);
    canards.limited[i] = command.limited;
    canards.verdicts[i] = record.verdicts[i];
  }
  canards.canard_rad = radians(record.canard_angle);
  return canards;
}

void TickReporter::report(const core::TickRecord& record, const Surroundings& surroundings) {
  changes_.look(record.time, record.phase, record.reason, sender_);
  changes_.look(record.time, record.verdicts, sender_);
  if (ticks_ % ticks_between_states_ == 0) {
    sender_.send(record.time, state_of(record));
    sender_.send(record.time, canards_of(record, surroundings.limits_rad));
  }
  if (surroundings.tick_s) {
    longest_tick_s_ = std::max(longest_tick_s_.value_or(0.0), *surroundings.tick_s);
  }
  if (ticks_ % health_period == 0) {
    sender_.send(record.time, Health{.gyro = record.motion.gyro,
                                     .accelerometer = record.motion.accelerometer,
                                     .verdicts = record.verdicts,
                                     .timing_fault = record.timing_fault,
                                     .longest_tick_s = longest_tick_s_,
                                     .late_ticks = surroundings.late_ticks,
                                     .bus = surroundings.bus,
                                     .gateway = {}});
    longest_tick_s_.reset();
  }
  ticks_ += 1;
}

bool LimitTap::send(const hal::CanFrame& frame) {
  const auto decoded = protocol::decode_from_avionics(avionics::bus_frame(frame));
  if (decoded.message) {
    if (const auto* limits = std::get_if<protocol::LimitReport>(&*decoded.message)) {
      for (std::size_t i = 0; i < limits_rad_.size(); ++i) {
        limits_rad_[i] = static_cast<double>(limits->limit[i].radians());
      }
    }
  }
  return bus_.send(frame);
}

}  // namespace fantail::telemetry
