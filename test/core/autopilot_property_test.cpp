// SPDX-License-Identifier: MIT
#include "chaos.hpp"
#include "core/autopilot.hpp"
#include "core/finite.hpp"
#include "properties.hpp"

namespace fantail::core {
namespace {

float limit_rad(const FlightPlan& plan, std::size_t canard) {
  return std::min({plan.controller.canard_limit, Angle::from_degrees(20.0F), plan.canards.each[canard].mechanical_stop})
      .radians();
}

bool is_sound(const Motion& motion) {
  return is_finite(motion.roll_angle.radians()) && is_finite(motion.roll_rate_rad_s) &&
         is_finite(motion.specific_force_m_s2) && is_finite(motion.height_m) &&
         is_finite(motion.distance_along_guide_m) && is_finite(motion.speed_m_s) &&
         is_finite(motion.vertical_speed_m_s) && is_finite(motion.tilt.radians());
}

/// The first motion of one canard, followed from outside.
class FirstMotion {
 public:
  /// False when the command moved faster than the plan's rate before it had once reached its target.
  bool allows(const FlightPlan& plan, const CanardCommand& command, const std::optional<Angle>& encoder, float limit,
              float target_rad, float elapsed_s) {
    if (reached_ || !command.driven) {
      return true;
    }
    if (!position_rad_) {
      if (!encoder || !is_finite(encoder->radians())) {
        reached_ = true;  // an encoder that stayed silent: driven without the courtesy
        return true;
      }
      position_rad_ = std::clamp(encoder->radians(), -limit, limit);
    }
    const float moved = std::abs(command.angle.radians() - *position_rad_);
    position_rad_ = command.angle.radians();
    // Of canards that share a work the record does not say what each is asked for, but whether it was given it.
    const bool shares = plan.run.canard_fault == CanardFaultPolicy::share;
    reached_ = *position_rad_ == target_rad || (shares && (!command.limited || std::abs(*position_rad_) == limit));
    return moved <= plan.canards.first_motion_rate_rad_s * std::max(elapsed_s, 0.0F) + 1e-6F;
  }

 private:
  std::optional<float> position_rad_;
  bool reached_ = false;
};

RC_GTEST_PROP(Autopilot, WhateverComesInTheCommandsKeepTheirLimits, (std::uint32_t seed)) {
  RandomStream random{seed};
  const FlightPlan plan = random_plan(random);
  Autopilot autopilot{plan};
  Chaos chaos{random};
  std::array<FirstMotion, canard_count> first_motions;
  Phase phase = Phase::safe;
  Angle roll_angle;
  float largest_rate = 0.0F;
  float silent_s = 0.0F;  // since the gyro was last believed
  float rate_before_silence = 0.0F;
  std::optional<Microseconds> last_time;
  bool controlled = false;
  bool returned = false;
  for (int tick = 0; tick < 12'000; ++tick) {
    const Inputs inputs = chaos.next();
    const TickRecord record = autopilot.step(inputs);
    const float elapsed_s = last_time ? seconds(inputs.time - *last_time) : 0.0F;

    RC_ASSERT(is_sound(record.motion));
    RC_ASSERT(is_finite(record.command.radians()));
    RC_ASSERT(abs(record.command) <= plan.controller.canard_limit);
    RC_ASSERT(record.phase == Phase::controlling || record.command.radians() == 0.0F);
    RC_ASSERT(record.command_status == CommandStatus::controlling || record.command.radians() == 0.0F);

    for (std::size_t i = 0; i < canard_count; ++i) {
      const CanardPlan& canard = plan.canards.each[i];
      const CanardCommand& command = record.canards[i];
      const float limit = limit_rad(plan, i);
      RC_ASSERT(std::abs(command.angle.radians()) <= limit);
      RC_ASSERT(is_finite(command.pulse_us));
      float wanted = (canard.direction == Direction::reversed ? -record.command : record.command).radians() +
                     canard.trim.radians();
      if (record.phase == Phase::safe && inputs.canard_request) {
        const float requested = (*inputs.canard_request)[i].radians();
        wanted = is_finite(requested) ? requested : canard.trim.radians();
      }
      const float target = std::clamp(wanted, -limit, limit);
      RC_ASSERT(first_motions[i].allows(plan, command, inputs.encoders[i], limit, target, elapsed_s));
    }

    // The angle may only move as fast as the gyro has said, over this tick and what was left to bridge before it, but
    // for the two instants that define its zero.
    largest_rate = std::max(0.98F * largest_rate, std::abs(record.motion.roll_rate_rad_s));
    const bool fresh = record.motion.gyro == SensorState::fresh;
    silent_s += elapsed_s;
    const bool bridged = fresh && silent_s > seconds(plan.motion.stale_time);
    const float gap_rate = std::max(rate_before_silence, std::abs(record.motion.roll_rate_rad_s));
    const float gap_rad = bridged ? gap_rate * (silent_s + 0.002F) : 0.0F;
    if (fresh) {
      silent_s = 0.0F;
      rate_before_silence = std::abs(record.motion.roll_rate_rad_s);
    }
    const bool zeroed = record.phase != phase && (record.phase == Phase::launched ||
                                                  (phase == Phase::armed && record.phase == Phase::controlling));
    if (zeroed) {
      RC_ASSERT(record.motion.roll_angle == Angle{});
    } else {
      const float bridge_s = 2.0F * seconds(plan.motion.stale_time) + 0.002F;
      RC_ASSERT(abs(record.motion.roll_angle - roll_angle).radians() <=
                largest_rate * bridge_s * 1.3F + gap_rad + 1e-3F);
    }

    controlled = controlled || record.phase == Phase::controlling;
    returned = returned || (phase == Phase::launched && record.phase == Phase::armed);
    phase = record.phase;
    roll_angle = record.motion.roll_angle;
    last_time = inputs.time;
  }
  RC_CLASSIFY(controlled, "controlled");
  RC_CLASSIFY(returned, "returned to the pad");
}

}  // namespace
}  // namespace fantail::core
