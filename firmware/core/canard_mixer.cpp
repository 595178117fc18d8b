// SPDX-License-Identifier: MIT
#include "core/canard_mixer.hpp"

#include <algorithm>

#include "core/finite.hpp"

namespace fantail::core {
namespace {

constexpr Microseconds encoder_patience{500'000};

// Play, encoder noise, and a stop that nobody measured to a degree.
constexpr Angle play_of_a_stop = Angle::from_degrees(2.0F);

/// What is no number means trim.
Angle limited_to(Angle limit, Angle trim, Angle wanted) {
  return clamp(is_finite(wanted.radians()) ? wanted : trim, limit);
}

}  // namespace

CanardMixer::CanardMixer(const CanardsPlan& plan, Angle plan_limit)
    : first_motion_rate_rad_s_{plan.first_motion_rate_rad_s} {
  for (std::size_t i = 0; i < canard_count; ++i) {
    canards_[i] = made_of(plan.each[i], plan_limit);
  }
}

CanardMixer::Canard CanardMixer::made_of(const CanardPlan& plan, Angle plan_limit) {
  return {.sense = plan.direction == Direction::reversed ? -1.0F : 1.0F,
          .trim = plan.trim,
          .limit = std::min({plan_limit, hard_canard_limit, plan.mechanical_stop}),
          .stop = plan.mechanical_stop,
          .pulse_centre_us = plan.pulse_centre_us,
          .pulse_per_radian_us = plan.pulse_per_radian_us,
          .position = {},
          .first_motion_done = false};
}

bool CanardMixer::moves_as_planned(std::size_t canard, const CanardsPlan& plan, Angle plan_limit) const {
  const Canard& now = canards_[canard];
  const Canard planned = made_of(plan.each[canard], plan_limit);
  return now.sense == planned.sense && now.trim == planned.trim && now.limit == planned.limit &&
         now.stop == planned.stop && now.pulse_centre_us == planned.pulse_centre_us &&
         now.pulse_per_radian_us == planned.pulse_per_radian_us;
}

void CanardMixer::mix(Microseconds time, Angle roll_command,
                      const std::optional<std::array<Angle, canard_count>>& requested, const EncoderAngles& encoders,
                      CanardCommands& commands) {
  if (!power_up_) {
    power_up_ = time;
    last_time_ = time;
  }
  // A clock that runs backwards is a timing fault; it must not turn the first motion round and past its limits.
  const Microseconds elapsed = std::max(time - last_time_, Microseconds{0});
  last_time_ = time;
  for (std::size_t i = 0; i < canard_count; ++i) {
    Canard& canard = canards_[i];
    const Angle wanted = requested ? (*requested)[i] : canard.sense * roll_command + canard.trim;
    drive(time, elapsed, canard, wanted, encoders[i], commands[i]);
  }
}

// Meets LIM-1, LIM-2.
void CanardMixer::drive(Microseconds time, Microseconds elapsed, Canard& canard, Angle wanted,
                        const std::optional<Angle>& encoder, CanardCommand& command) const {
  Angle angle = wanted;
  bool limited = false;
  if (!(abs(wanted) <= canard.limit)) {  // seldom; what is no number is not within it either
    wanted = is_finite(wanted.radians()) ? wanted : canard.trim;
    angle = clamp(wanted, canard.limit);
    limited = angle != wanted;
  }
  if (!canard.first_motion_done) {
    if (!canard.position) {
      start_from_encoder(time, canard, encoder, angle);
    }
    if (!canard.position) {
      command = {};
      return;
    }
    angle = approach(elapsed, canard, angle);
    limited = angle != wanted;
  }
  command.angle = angle;
  command.pulse_us = canard.pulse_centre_us + canard.pulse_per_radian_us * angle.radians();
  command.driven = true;
  command.limited = limited;
}

// Meets LIM-3.
void CanardMixer::start_from_encoder(Microseconds time, Canard& canard, const std::optional<Angle>& encoder,
                                     Angle target) const {
  if (encoder && is_finite(encoder->radians())) {
    canard.position = clamp(*encoder, canard.limit);
  } else if (time - *power_up_ >= encoder_patience) {
    canard.position = target;
  }
}

Angle CanardMixer::approach(Microseconds elapsed, Canard& canard, Angle target) const {
  const Angle largest_step = Angle::from_radians(first_motion_rate_rad_s_ * seconds(elapsed));
  const Angle remaining = target - *canard.position;
  canard.first_motion_done = abs(remaining) <= largest_step;
  // Meets LIM-1.
  // Last of all the limit: a position that came back after a reset, or of which a bit has flipped, may be anything.
  canard.position = limited_to(canard.limit, canard.trim, *canard.position + clamp(remaining, largest_step));
  return canard.first_motion_done ? target : *canard.position;
}

std::optional<Angle> CanardMixer::contribution(std::size_t canard, const std::optional<Angle>& encoder) const {
  const Canard& of = canards_[canard];
  const bool believed = encoder && abs(*encoder) <= of.stop + play_of_a_stop;
  return believed ? std::optional{of.sense * (*encoder - of.trim)} : std::nullopt;
}

std::optional<Angle> CanardMixer::canard_angle(const EncoderAngles& encoders) const {
  Angle sum;
  int count = 0;
  for (std::size_t i = 0; i < canard_count; ++i) {
    if (encoders[i] && is_finite(encoders[i]->radians())) {
      sum += canards_[i].sense * (*encoders[i] - canards_[i].trim);
      count += 1;
    }
  }
  return count > 0 ? std::optional{sum / static_cast<float>(count)} : std::nullopt;
}

}  // namespace fantail::core
