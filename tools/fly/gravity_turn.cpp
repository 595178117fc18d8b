// SPDX-License-Identifier: MIT
#include "fly/gravity_turn.hpp"

#include <algorithm>
#include <cmath>

#include "sim/units.hpp"

namespace fantail::fly {
namespace {

/// x across, z up.
struct State {
  double x_m = 0.0;
  double z_m = 0.0;
  double vx_m_s = 0.0;
  double vz_m_s = 0.0;
};

State advanced(const State& s, const State& rate, double dt_s) {
  return {s.x_m + dt_s * rate.x_m, s.z_m + dt_s * rate.z_m, s.vx_m_s + dt_s * rate.vx_m_s,
          s.vz_m_s + dt_s * rate.vz_m_s};
}

class Flight {
 public:
  explicit Flight(const sim::Scenario& scenario)
      : scenario_{scenario},
        guide_length_m_{scenario.guide.length_m.value_or(static_cast<double>(scenario.plan.guide.length_m))},
        guide_x_{std::sin(scenario.guide.tilt_rad)},
        guide_z_{std::cos(scenario.guide.tilt_rad)} {}

  [[nodiscard]] State rate(double time_s, const State& s) const {
    const sim::Vehicle& vehicle = scenario_.vehicle;
    const sim::Burn burn = vehicle.motor.at(time_s);
    const double impulse_n_s = vehicle.motor.impulse_n_s();
    const double burnt_kg = impulse_n_s > 0.0 ? vehicle.motor.propellant_kg() * burn.impulse_n_s / impulse_n_s : 0.0;
    const double mass_kg = vehicle.mass_kg - burnt_kg;
    const double speed_m_s = std::hypot(s.vx_m_s, s.vz_m_s);
    const double mach = speed_m_s / scenario_.atmosphere.speed_of_sound_m_s(s.z_m);
    const double drag_area_m2 = vehicle.drag_area_m2 * vehicle.drag_over_mach.at(mach);
    const double drag_n = 0.5 * scenario_.atmosphere.density_kg_m3(s.z_m) * drag_area_m2 * speed_m_s * speed_m_s;
    const double along_m_s2 = (burn.thrust_n - drag_n) / mass_kg;
    if (on_guide(s)) {
      const double net_m_s2 = std::max(0.0, along_m_s2 - sim::gravity_m_s2 * guide_z_);
      return {s.vx_m_s, s.vz_m_s, net_m_s2 * guide_x_, net_m_s2 * guide_z_};
    }
    const double x = speed_m_s > 0.0 ? s.vx_m_s / speed_m_s : guide_x_;
    const double z = speed_m_s > 0.0 ? s.vz_m_s / speed_m_s : guide_z_;
    return {s.vx_m_s, s.vz_m_s, along_m_s2 * x, along_m_s2 * z - sim::gravity_m_s2};
  }

 private:
  [[nodiscard]] bool on_guide(const State& s) const { return std::hypot(s.x_m, s.z_m) < guide_length_m_; }

  const sim::Scenario& scenario_;
  double guide_length_m_;
  double guide_x_;
  double guide_z_;
};

}  // namespace

GravityTurn gravity_turn(const sim::Scenario& scenario) {
  constexpr double dt_s = gravity_turn_step_s;
  constexpr int most_steps = 600'000;
  const Flight flight{scenario};
  const auto limit_rad = static_cast<double>(scenario.plan.run.tilt_limit.radians());
  const double zero_rad = scenario.plan.run.tilt_from == core::TiltOrigin::guide ? scenario.guide.tilt_rad : 0.0;
  GravityTurn result;
  State s;
  std::optional<double> liftoff_s;
  for (int step = 0; step < most_steps; ++step) {
    const double time_s = dt_s * step;
    const State middle = advanced(s, flight.rate(time_s, s), 0.5 * dt_s);
    s = advanced(s, flight.rate(time_s + 0.5 * dt_s, middle), dt_s);
    if (!liftoff_s && s.vz_m_s > 0.0) {
      liftoff_s = time_s;
    }
    if (!liftoff_s) {
      if (time_s > scenario.vehicle.motor.burnout_s()) {
        break;
      }
      continue;
    }
    if (s.vz_m_s < 0.0) {
      break;
    }
    result.apogee_m = s.z_m;
    result.apogee_s = time_s - *liftoff_s;
    result.tilts_rad.push_back(std::abs(std::atan2(s.vx_m_s, s.vz_m_s) - zero_rad));
    if (!result.tilt_limit_s && result.tilts_rad.back() > limit_rad) {
      result.tilt_limit_s = time_s - *liftoff_s;
    }
  }
  return result;
}

}  // namespace fantail::fly
