// SPDX-License-Identifier: MIT
#include "core/canard_mixer.hpp"

#include <algorithm>

#include "core/finite.hpp"

namespace fantail::core {
namespace {

constexpr Microseconds encoder_patience{500'000};

Angle signed_by(Direction direction, Angle angle) { return direction == Direction::reversed ? -angle : angle; }

}  // namespace

CanardMixer::CanardMixer(const CanardsPlan& plan, Angle plan_limit) : plan_{plan} {
  for (std::size_t i = 0; i < canard_count; ++i) {
    limits_[i] = std::min({plan_limit, hard_canard_limit, plan.each[i].mechanical_stop});
  }
}

CanardCommands CanardMixer::mix(Microseconds time, Angle roll_command,
                                const std::optional<std::array<Angle, canard_count>>& requested,
                                const EncoderAngles& encoders) {
  if (!power_up_) {
    power_up_ = time;
    last_time_ = time;
  }
  // A clock that runs backwards is a timing fault; it must not turn the first motion round and past its limits.
  const Microseconds elapsed = std::max(time - last_time_, Microseconds{0});
  const Angle first_step = Angle::from_radians(plan_.first_motion_rate_rad_s * seconds(elapsed));
  last_time_ = time;

  CanardCommands commands;
  for (std::size_t i = 0; i < canard_count; ++i) {
    const CanardPlan& canard = plan_.each[i];
    const Angle mixed = signed_by(canard.direction, roll_command) + canard.trim;
    Angle wanted = requested ? (*requested)[i] : mixed;
    if (!is_finite(wanted.radians())) {
      wanted = canard.trim;
    }
    const Angle target = clamp(wanted, limits_[i]);
    start_from_encoder(time, i, encoders[i], target);
    if (!first_motion_[i].position) {
      continue;
    }
    const Angle angle = first_motion_[i].done ? target : approach(i, target, first_step);
    commands[i] = {.angle = angle,
                   .pulse_us = canard.pulse_centre_us + canard.pulse_per_radian_us * angle.radians(),
                   .driven = true,
                   .limited = angle != wanted};
  }
  return commands;
}

void CanardMixer::start_from_encoder(Microseconds time, std::size_t canard, const std::optional<Angle>& encoder,
                                     Angle target) {
  FirstMotion& motion = first_motion_[canard];
  if (motion.position) {
    return;
  }
  if (encoder && is_finite(encoder->radians())) {
    motion.position = clamp(*encoder, limits_[canard]);
  } else if (time - *power_up_ >= encoder_patience) {
    motion.position = target;
  }
}

Angle CanardMixer::approach(std::size_t canard, Angle target, Angle largest_step) {
  FirstMotion& motion = first_motion_[canard];
  const Angle remaining = target - *motion.position;
  motion.done = abs(remaining) <= largest_step;
  *motion.position += clamp(remaining, largest_step);
  return motion.done ? target : *motion.position;
}

std::optional<Angle> CanardMixer::canard_angle(const EncoderAngles& encoders) const {
  Angle sum;
  float count = 0.0F;
  for (std::size_t i = 0; i < canard_count; ++i) {
    if (encoders[i] && is_finite(encoders[i]->radians())) {
      sum += signed_by(plan_.each[i].direction, *encoders[i] - plan_.each[i].trim);
      count += 1.0F;
    }
  }
  return count > 0.0F ? std::optional{sum / count} : std::nullopt;
}

}  // namespace fantail::core
