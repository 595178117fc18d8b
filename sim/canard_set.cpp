// SPDX-License-Identifier: MIT
#include "sim/canard_set.hpp"

#include "sim/servo.hpp"

namespace fantail::sim {
namespace {

std::array<Servo, hal::canards> make_servos(const Vehicle& vehicle, Random random) {
  const auto drawn = drawn_servos(vehicle, random);
  return {Servo{drawn[0]}, Servo{drawn[1]}, Servo{drawn[2]}, Servo{drawn[3]}};
}

}  // namespace

std::array<ServoParameters, hal::canards> drawn_servos(const Vehicle& vehicle, Random servo_spread) {
  std::array<ServoParameters, hal::canards> servos{};
  for (ServoParameters& servo : servos) {
    servo = one_of_the_spread(vehicle.servo, vehicle.servo_spread, servo_spread);
  }
  return servos;
}

CanardSet::CanardSet(const Vehicle& vehicle, Random encoder_noise, Random servo_spread)
    : mounting_{vehicle.canards},
      air_{vehicle.canard_air},
      servos_{make_servos(vehicle, servo_spread)},
      encoders_{{vehicle.canards[0].encoder_zero_rad, vehicle.canards[1].encoder_zero_rad,
                 vehicle.canards[2].encoder_zero_rad, vehicle.canards[3].encoder_zero_rad},
                vehicle.encoder,
                encoder_noise} {}

void CanardSet::step(double time_s, double dt_s, const std::array<std::optional<hal::Pulse>, hal::canards>& pulses,
                     const CanardFlow& flow) {
  if (air_.hinge_moment_m3) {
    load_servos(flow);
  }
  constexpr double microseconds_per_nanosecond = 1e-3;
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    servos_[i].step(time_s, dt_s, [&pulse = pulses[i]] {
      return pulse ? std::optional{microseconds_per_nanosecond * static_cast<double>(pulse->count())} : std::nullopt;
    });
  }
}

Vector3 CanardSet::across_rad(double roll_rate_rad_s, double speed_m_s) const {
  const double of_roll_rad = angle_of_roll_rad(air_, roll_rate_rad_s, speed_m_s);
  const auto lift_rad = [&](std::size_t i) {
    return sim::torque_angle_rad(air_, from_trim_rad(i, servos_[i].angle_rad()), of_roll_rad);
  };
  return {.y = lift_rad(3) - lift_rad(1), .z = lift_rad(0) - lift_rad(2)};
}

void CanardSet::load_servos(const CanardFlow& flow) {
  const double stiffness_n_m_per_rad =
      0.5 * flow.density_kg_m3 * flow.speed_m_s * flow.speed_m_s * *air_.hinge_moment_m3;
  const double of_roll_rad = angle_of_roll_rad(air_, flow.roll_rate_rad_s, flow.speed_m_s);
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    const double against_roll_rad = mounting_[i].reversed ? of_roll_rad : -of_roll_rad;
    servos_[i].set_load(ShaftLoad{.stiffness_n_m_per_rad = stiffness_n_m_per_rad,
                                  .free_angle_rad = mounting_[i].trim_rad + against_roll_rad});
  }
}

std::array<double, hal::canards> CanardSet::shafts_rad() const {
  return {servos_[0].angle_rad(), servos_[1].angle_rad(), servos_[2].angle_rad(), servos_[3].angle_rad()};
}

hal::EncoderReading CanardSet::read_encoders(hal::Microseconds time) { return encoders_.sample(time, shafts_rad()); }

}  // namespace fantail::sim
