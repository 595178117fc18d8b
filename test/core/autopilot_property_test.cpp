// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/autopilot.hpp"
#include "core/finite.hpp"
#include "core/flight_plan_fields.hpp"
#include "random_stream.hpp"

namespace fantail::core {
namespace {

constexpr float g = standard_gravity_m_s2;

/// Any plan that may fly, with the numbers near the ends of their ranges as likely as those in between.
FlightPlan random_plan(RandomStream& random) {
  for (;;) {
    FlightPlan plan = default_plan();
    for (const PlanField& field : flight_plan_fields()) {
      if (field.is_list() || random.chance(0.7)) {
        continue;
      }
      for (std::size_t slot = 0; slot < field.slots; ++slot) {
        const float drawn = random.chance(0.3) ? (random.chance(0.5) ? field.minimum : field.maximum)
                                               : random.between(field.minimum, field.maximum);
        field.set(plan, slot, field.kind == FieldKind::number ? drawn : std::floor(drawn));
      }
    }
    if (!validate(plan)) {
      return plan;
    }
  }
}

/// Sensors, switches and a clock of which nothing can be relied on, but which now and then look like a flight for
/// long enough to get the autopilot into every phase.
class Chaos {
 public:
  explicit Chaos(RandomStream& random)
      : random_{random}, bad_share_{random.chance(0.4) ? 0.0 : (random.chance(0.5) ? 0.002 : 0.05)} {}

  Inputs next() {
    const Microseconds tick = advance_clock();
    if (inputs_.time >= scene_end_) {
      change_scene();
    }
    if (random_.chance(0.98)) {
      const Microseconds sampled = inputs_.time - Microseconds{random_.whole(0, 300)};
      inputs_.gyro = {sampled, {rate() + roll_rate_, rate(), rate()}, SampleQuality::valid};
      for (AccelerometerSample& sample : inputs_.accelerometers) {
        sample = {sampled, {axial_ + force(), force(), force()}, SampleQuality::valid};
      }
    }
    Inputs result = inputs_;
    result.arm_switch_closed = !random_.chance(0.0002);
    result.arm_command = random_.chance(0.02);
    result.start_command = random_.chance(0.01);
    for (auto& encoder : result.encoders) {
      encoder = random_.chance(0.9) ? std::optional{Angle::from_radians(any_number(0.2F))} : std::nullopt;
    }
    if (random_.chance(0.2)) {
      result.canard_request.emplace();
      for (Angle& angle : *result.canard_request) {
        angle = Angle::from_radians(any_number(0.5F));
      }
    }
    spoil(result, tick);
    return result;
  }

 private:
  Microseconds advance_clock() {
    Microseconds tick{random_.whole(800, 1'200)};
    if (bad_share_ > 0.0 && random_.chance(0.0003)) {
      tick = Microseconds{random_.chance(0.5) ? random_.whole(-2'000'000, 0) : random_.whole(5'000, 2'000'000)};
    }
    inputs_.time += tick;
    return tick;
  }

  void change_scene() {
    scene_end_ = inputs_.time + Microseconds{random_.whole(100'000, 4'000'000)};
    const int scene = random_.whole(0, 4);
    axial_ = scene <= 1 ? g : scene <= 3 ? random_.between(3.0F, 16.0F) * g : random_.between(-2.0F, 1.5F) * g;
    roll_rate_ = scene <= 1 ? 0.0F : random_.between(-15.0F, 15.0F);
  }

  float rate() { return random_.between(-0.01F, 0.01F); }
  float force() { return random_.between(-0.3F, 0.3F); }

  float any_number(float usual) {
    if (!random_.chance(bad_share_)) {
      return random_.between(-usual, usual);
    }
    constexpr std::array<float, 8> odd{std::numeric_limits<float>::quiet_NaN(),
                                       std::numeric_limits<float>::infinity(),
                                       -std::numeric_limits<float>::infinity(),
                                       std::numeric_limits<float>::max(),
                                       std::numeric_limits<float>::lowest(),
                                       std::numeric_limits<float>::denorm_min(),
                                       -0.0F,
                                       1e4F};
    return odd[static_cast<std::size_t>(random_.whole(0, 7))];
  }

  void spoil(Vector3& v) {
    for (float* component : {&v.x, &v.y, &v.z}) {
      if (random_.chance(bad_share_)) {
        *component = any_number(2000.0F);
      }
    }
  }

  void spoil(Inputs& inputs, Microseconds tick) {
    constexpr std::array qualities{SampleQuality::valid, SampleQuality::saturated, SampleQuality::invalid,
                                   SampleQuality::absent};
    auto one = [&](auto& sample, Vector3& value) {
      spoil(value);
      if (random_.chance(bad_share_)) {
        sample.quality = qualities[static_cast<std::size_t>(random_.whole(0, 3))];
      }
      if (random_.chance(bad_share_)) {
        sample.time += Microseconds{random_.whole(-10'000, 10'000)} - tick;
      }
      if (random_.chance(bad_share_ * 0.1)) {
        sample.time = random_.chance(0.5) ? Microseconds::min() : Microseconds::max();
      }
    };
    one(inputs.gyro, inputs.gyro.rate_rad_s);
    for (AccelerometerSample& sample : inputs.accelerometers) {
      one(sample, sample.specific_force_m_s2);
    }
  }

  RandomStream& random_;
  double bad_share_;
  Inputs inputs_{.time = Microseconds{1'000'000'000}};
  Microseconds scene_end_{};
  float axial_ = g;
  float roll_rate_ = 0.0F;
};

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
    reached_ = command.angle.radians() == target_rad;
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
    const bool zeroed = record.phase != phase && (record.phase == Phase::launched ||
                                                  (phase == Phase::armed && record.phase == Phase::controlling));
    if (zeroed) {
      RC_ASSERT(record.motion.roll_angle == Angle{});
    } else {
      const float bridge_s = 2.0F * seconds(plan.motion.stale_time) + 0.002F;
      RC_ASSERT(abs(record.motion.roll_angle - roll_angle).radians() <= largest_rate * bridge_s * 1.3F + 1e-3F);
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
