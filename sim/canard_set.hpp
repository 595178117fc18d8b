// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "hal/encoder.hpp"
#include "hal/servo.hpp"
#include "sim/canard_aerodynamics.hpp"
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

  void step(double time_s, double dt_s, const std::array<std::optional<hal::Pulse>, hal::canards>& pulses);

  /// Mean angle in the sense of positive roll moment, trim taken off: u_fin of Eq 1.
  [[nodiscard]] double deflection_rad() const;
  /// The same as the air answers it, averaged over the last step: where a canard stalls, less. The roll rate and the
  /// speed of the air along the axis are those of that step.
  [[nodiscard]] double mean_torque_angle_rad(double roll_rate_rad_s, double speed_m_s) const;

  [[nodiscard]] hal::EncoderReading read_encoders(hal::Microseconds time);

  /// As Servo::fail.
  void fail(std::size_t canard, ServoFault fault, std::optional<double> fault_angle_rad = std::nullopt) {
    servos_[canard].fail(fault, fault_angle_rad);
  }
  void unplug_encoder(std::size_t canard) { encoders_.unplug(canard); }
  void make_encoder_noisy(std::size_t canard, double noise_counts) { encoders_.set_noise(canard, noise_counts); }

 private:
  /// `answer` is what becomes of a canard's angle from its trim, in the sense of positive roll moment.
  template <typename AngleOf, typename Answer>
  [[nodiscard]] double average(AngleOf angle_of, Answer answer) const;

  std::array<CanardMounting, hal::canards> mounting_;
  CanardAerodynamics air_;
  std::array<Servo, hal::canards> servos_;
  EncoderModel encoders_;
};

}  // namespace fantail::sim
