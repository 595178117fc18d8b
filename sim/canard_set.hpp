// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "hal/encoder.hpp"
#include "hal/servo.hpp"
#include "sim/canard_aerodynamics.hpp"
#include "sim/rotation.hpp"
#include "sim/sensor_models.hpp"
#include "sim/servo.hpp"
#include "sim/vehicle.hpp"

namespace fantail::sim {

/// Four servos of a batch, as the stream draws them.
[[nodiscard]] std::array<ServoParameters, hal::canards> drawn_servos(const Vehicle& vehicle, Random servo_spread);

/// The four canards as built into one vehicle: servo pulses in, roll deflection and encoder counts out.
class CanardSet {
 public:
  /// Each is a stream of its own: the noise of the encoders, and how the servos differ from each other.
  CanardSet(const Vehicle& vehicle, Random encoder_noise, Random servo_spread);

  /// The flow is that at the begin of the step; it turns no shaft unless the vehicle has a hinge moment.
  void step(double time_s, double dt_s, const std::array<std::optional<hal::Pulse>, hal::canards>& pulses,
            const CanardFlow& flow);

  /// Mean angle in the sense of positive roll moment, trim taken off, as the air answers it: u_fin of Eq 1. Where a
  /// canard stalls, less; there the roll rate counts, and the speed of the air along the axis.
  [[nodiscard]] double torque_angle_rad(double roll_rate_rad_s, double speed_m_s) const {
    return average([](const Servo& servo) { return servo.angle_rad(); }, roll_rate_rad_s, speed_m_s);
  }
  /// The same, averaged over the last step.
  [[nodiscard]] double mean_torque_angle_rad(double roll_rate_rad_s, double speed_m_s) const {
    return average([](const Servo& servo) { return servo.mean_angle_rad(); }, roll_rate_rad_s, speed_m_s);
  }

  /// What the four do to the side: the sum of their angles as vectors along what each lifts, in the frame of the
  /// rolling rocket (y, z). Canard 1 stands out towards +y, 2 towards +z; a positive one lifts towards where positive
  /// roll goes. Zero while all turn alike.
  [[nodiscard]] Vector3 across_rad(double roll_rate_rad_s, double speed_m_s) const;

  /// Where each shaft truly stands, as Servo::angle_rad().
  [[nodiscard]] std::array<double, hal::canards> shafts_rad() const;

  [[nodiscard]] hal::EncoderReading read_encoders(hal::Microseconds time);

  /// As Servo::fail.
  void fail(std::size_t canard, ServoFault fault, std::optional<double> fault_angle_rad = std::nullopt) {
    servos_[canard].fail(fault, fault_angle_rad);
  }
  void make_encoder_noisy(std::size_t canard, double noise_counts) { encoders_.set_noise(canard, noise_counts); }

 private:
  void load_servos(const CanardFlow& flow);
  [[nodiscard]] double from_trim_rad(std::size_t canard, double shaft_rad) const {
    const double from_trim_rad = shaft_rad - mounting_[canard].trim_rad;
    return mounting_[canard].reversed ? -from_trim_rad : from_trim_rad;
  }
  template <typename AngleOf>
  [[nodiscard]] double average(AngleOf angle_of, double roll_rate_rad_s, double speed_m_s) const;

  std::array<CanardMounting, hal::canards> mounting_;
  CanardAerodynamics air_;
  std::array<Servo, hal::canards> servos_;
  EncoderModel encoders_;
};

template <typename AngleOf>
double CanardSet::average(AngleOf angle_of, double roll_rate_rad_s, double speed_m_s) const {
  const double of_roll_rad = angle_of_roll_rad(air_, roll_rate_rad_s, speed_m_s);
  double sum_rad = 0.0;
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    sum_rad += sim::torque_angle_rad(air_, from_trim_rad(i, angle_of(servos_[i])), of_roll_rad);
  }
  return sum_rad / static_cast<double>(servos_.size());
}

}  // namespace fantail::sim
