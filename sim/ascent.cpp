// SPDX-License-Identifier: MIT
#include "sim/ascent.hpp"

#include <cmath>

namespace fantail::sim {
namespace {

// x - x^3/3! + ..., or 1 - x^2/2! + ... when `first` is 1 and `n` is 0; up to a right angle. The C library's are not
// the same on every machine.
double alternating_series(double first, int n, double x) {
  double sum = 0.0;
  for (double term = first; n < 30; n += 2) {
    sum += term;
    term *= -x * x / static_cast<double>((n + 1) * (n + 2));
  }
  return sum;
}

}  // namespace

Ascent::Ascent(const AscentParameters& parameters)
    : parameters_{parameters},
      cos_tilt_{alternating_series(1.0, 0, parameters.guide_tilt_rad)},
      gravity_along_m_s2_{gravity_m_s2 * cos_tilt_},
      lateral_specific_force_m_s2_{gravity_m_s2 *
                                   alternating_series(parameters.guide_tilt_rad, 1, parameters.guide_tilt_rad)},
      half_drag_area_m2_{0.5 * parameters.drag_area_m2},
      kg_per_n_s_{parameters.motor.impulse_n_s() > 0.0
                      ? parameters.motor.propellant_kg() / parameters.motor.impulse_n_s()
                      : 0.0},
      density_{parameters.atmosphere},
      speed_of_sound_m_s_{parameters.atmosphere.speed_of_sound_m_s(0.0)},
      now_{.mass_kg = parameters.mass_kg,
           .density_kg_m3 = density_.at(0.0),
           .specific_force_m_s2 = gravity_along_m_s2_} {}

double Ascent::half_drag_area_m2(double speed_m_s) const {
  return parameters_.drag_over_mach.is_there()
             ? half_drag_area_m2_ * parameters_.drag_over_mach.at(std::abs(speed_m_s) / speed_of_sound_m_s_)
             : half_drag_area_m2_;
}

Ascent::Instant Ascent::in_flight(double time_s, double speed_m_s, double density_kg_m3) const {
  const Burn burn = parameters_.motor.at(time_s);
  const double mass_kg = parameters_.mass_kg - kg_per_n_s_ * burn.impulse_n_s;
  // The division waits for nothing but the time; dividing the force would put it into the chain that speed goes
  // through.
  const double per_kg = 1.0 / mass_kg;
  const double drag_n = half_drag_area_m2(speed_m_s) * density_kg_m3 * (speed_m_s * std::abs(speed_m_s));
  return {.mass_kg = mass_kg, .density_kg_m3 = density_kg_m3, .specific_force_m_s2 = (burn.thrust_n - drag_n) * per_kg};
}

void Ascent::advance_to(double time_s) {
  switch (stage_) {
    case Stage::pad: wait_on_pad(time_s); break;
    case Stage::flight: fly(time_s); break;
    case Stage::landed: break;
  }
  if (!events_.burnout_s && time_s >= parameters_.motor.burnout_s() && kg_per_n_s_ > 0.0) {
    events_.burnout_s = time_s;
  }
}

void Ascent::wait_on_pad(double time_s) {
  time_s_ = time_s;
  if (time_s < 0.0) {
    return;
  }
  now_ = in_flight(time_s, 0.0, now_.density_kg_m3);
  if (now_.specific_force_m_s2 > gravity_along_m_s2_) {
    stage_ = Stage::flight;
    events_.liftoff_s = events_.liftoff_s.value_or(time_s);
  } else {
    now_.specific_force_m_s2 = gravity_along_m_s2_;
  }
}

void Ascent::fly(double time_s) {
  const double dt_s = time_s - time_s_;
  if (!(dt_s > 0.0)) {
    return;
  }
  const double half_s = 0.5 * dt_s;
  const double middle_speed_m_s = speed_m_s_ + half_s * (now_.specific_force_m_s2 - gravity_along_m_s2_);
  // Density is looked up where the speed at the start leads to, which is half a millimetre off at 100 g, or 1e-7 of the
  // density: so it need not wait for the acceleration. Its mean over the step serves the middle as well as a second
  // look-up would: both are off by the step squared, as the rule itself is.
  const double height_m = (distance_m_ + dt_s * speed_m_s_) * cos_tilt_;
  const double density_kg_m3 = density_.at(height_m);
  if (parameters_.drag_over_mach.is_there()) {
    speed_of_sound_m_s_ = parameters_.atmosphere.speed_of_sound_m_s(height_m);
  }
  const Instant middle = in_flight(time_s_ + half_s, middle_speed_m_s, 0.5 * (now_.density_kg_m3 + density_kg_m3));
  distance_m_ += dt_s * middle_speed_m_s;
  speed_m_s_ += dt_s * (middle.specific_force_m_s2 - gravity_along_m_s2_);
  time_s_ = time_s;
  left_guide_ = left_guide_ || distance_m_ >= parameters_.guide_length_m;
  highest_.look(time_s, distance_m_ * cos_tilt_, speed_m_s_, events_.apogee_s);
  if (speed_m_s_ < 0.0 && distance_m_ <= 0.0) {
    come_to_rest();
    return;
  }
  now_ = in_flight(time_s, speed_m_s_, density_kg_m3);
}

void Ascent::come_to_rest() {
  distance_m_ = 0.0;
  speed_m_s_ = 0.0;
  now_ = in_flight(time_s_, 0.0, density_.at(0.0));
  now_.specific_force_m_s2 = gravity_along_m_s2_;
  if (!left_guide_ && time_s_ < parameters_.motor.burnout_s()) {
    stage_ = Stage::pad;  // a motor that stutters let it hop, and the flight is still to come
  } else {
    stage_ = Stage::landed;
    events_.landing_s = time_s_;
  }
}

}  // namespace fantail::sim
