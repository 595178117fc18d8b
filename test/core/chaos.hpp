// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "core/flight_plan_fields.hpp"
#include "core/inputs.hpp"
#include "known_roll_model.hpp"
#include "random_stream.hpp"

namespace fantail::core {

/// Any plan that may fly, with the numbers near the ends of their ranges as likely as those in between.
inline FlightPlan random_plan(RandomStream& random) {
  for (;;) {
    FlightPlan plan = default_plan();
    if (random.chance(0.5)) {
      plan.gain_schedule.speeds_count = plan.gain_schedule.factors_count = 2;
      plan.gain_schedule.speeds_m_s = {random.between(0.0F, 30.0F), random.between(31.0F, 200.0F)};
      plan.gain_schedule.factors = {random.between(0.01F, 100.0F), random.between(0.01F, 100.0F)};
    }
    plan.roll_model = known_roll_model;  // for an observer
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
    result.second_gyro = inputs_.gyro;  // read where the plan asks for two
    result.second_gyro->rate_rad_s.x += rate();
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
    constexpr float g = standard_gravity_m_s2;
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
    one(*inputs.second_gyro, inputs.second_gyro->rate_rad_s);
    for (AccelerometerSample& sample : inputs.accelerometers) {
      one(sample, sample.specific_force_m_s2);
    }
  }

  RandomStream& random_;
  double bad_share_;
  Inputs inputs_{.time = Microseconds{1'000'000'000}};
  Microseconds scene_end_{};
  float axial_ = standard_gravity_m_s2;
  float roll_rate_ = 0.0F;
};

}  // namespace fantail::core
