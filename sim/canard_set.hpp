// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "hal/encoder.hpp"
#include "hal/servo.hpp"
#include "sim/sensor_models.hpp"
#include "sim/servo.hpp"
#include "sim/vehicle.hpp"

namespace fantail::sim {

/// The four canards as built into one vehicle: servo pulses in, roll deflection and encoder counts out.
class CanardSet {
 public:
  CanardSet(const Vehicle& vehicle, Random random);

  void step(double time_s, double dt_s, const std::array<std::optional<hal::Pulse>, hal::canards>& pulses);

  /// Mean angle in the sense of positive roll moment, trim taken off: u_fin of Eq 1.
  [[nodiscard]] double deflection_rad() const;
  /// The same, averaged over the last step.
  [[nodiscard]] double mean_deflection_rad() const;

  [[nodiscard]] hal::EncoderReading read_encoders(hal::Microseconds time);

  void fail(std::size_t canard, ServoFault fault) { servos_[canard].fail(fault); }
  void unplug_encoder(std::size_t canard) { encoders_.unplug(canard); }

 private:
  template <typename AngleOf>
  [[nodiscard]] double average(AngleOf angle_of) const;

  std::array<CanardMounting, hal::canards> mounting_;
  std::array<Servo, hal::canards> servos_;
  EncoderModel encoders_;
};

}  // namespace fantail::sim
