// SPDX-License-Identifier: MIT
#include "sim/rigid_flight.hpp"

#include <algorithm>
#include <cmath>

#include "sim/burning_rocket.hpp"

namespace fantail::sim {
namespace {

constexpr Vector3 gravity_vector_m_s2{.x = 0.0, .y = 0.0, .z = -gravity_m_s2};

Quaternion turned_about_z(double angle_rad) {
  const auto [sine, cosine] = sine_cosine(0.5 * angle_rad);
  return {.w = cosine, .x = 0.0, .y = 0.0, .z = sine};
}

constexpr Quaternion upright{.w = 0.5, .x = 0.5, .y = -0.5, .z = 0.5};  // x up, y south

/// The guide leans towards -y of the rocket's frame, so that it carries the rocket towards +y.
Quaternion attitude_in(const LaunchGuide& guide) {
  return turned_about_z(-guide.azimuth_rad) * upright * turned_about_z(-guide.tilt_rad);
}

}  // namespace

RigidFlight::RigidFlight(const RigidFlightParameters& parameters)
    : parameters_{parameters},
      burnt_per_n_s_{parameters.motor.impulse_n_s() > 0.0 ? 1.0 / parameters.motor.impulse_n_s() : 0.0},
      density_{parameters.atmosphere},
      density_kg_m3_{density_.at(0.0)},
      twist_{upright, attitude_in(parameters.guide)} {
  state_.attitude = attitude_in(parameters.guide);
  gravity_in_guide_m_s2_ = rotated_back(state_.attitude, gravity_vector_m_s2);
  body_ = body_at(0.0);
  specific_force_m_s2_ = -1.0 * gravity_in_guide_m_s2_;
}

double RigidFlight::tilt_rad() const {
  const Vector3 axis = rotated(state_.attitude, {.x = 1.0});
  return angle_off(axis.z, std::sqrt(axis.x * axis.x + axis.y * axis.y));
}

double RigidFlight::tilt_from_guide_rad() const {
  const Vector3 axis = rotated_back(attitude_in(parameters_.guide), rotated(state_.attitude, {.x = 1.0}));
  return angle_off(axis.x, std::sqrt(axis.y * axis.y + axis.z * axis.z));
}

RigidFlight::Body RigidFlight::body_at(double time_s) const {
  const Airframe& airframe = parameters_.airframe;
  const double propellant_kg = parameters_.motor.propellant_kg();
  const Burn burn = parameters_.motor.at(time_s);
  const BurningRocket now = burning_rocket(airframe,
                                           {.mass_kg = parameters_.mass_kg,
                                            .propellant_kg = propellant_kg,
                                            .roll_inertia_kg_m2 = parameters_.roll_inertia_kg_m2},
                                           burnt_per_n_s_ * burn.impulse_n_s);
  const double burning_per_s = burnt_per_n_s_ * burn.thrust_n;
  // The exhaust takes the pitch rate of the nozzle along; the inertia that is lost with it gives some of that back.
  const double nozzle_arm_m = airframe.nozzle_position_m.value_or(airframe.length_m) - now.centre_of_gravity_m;
  return {.inertia = now.inertia,
          .centre_of_gravity_m = now.centre_of_gravity_m,
          .jet_damping_n_m_s = burning_per_s * (propellant_kg * nozzle_arm_m * nozzle_arm_m +
                                                airframe.after_burnout.transverse_inertia_kg_m2 -
                                                airframe.at_liftoff.transverse_inertia_kg_m2),
          .thrust_n = burn.thrust_n};
}

Vector3 RigidFlight::through_air_m_s(const RigidState& state, const Vector3& wind_m_s) const {
  return rotated_back(state.attitude, state.velocity_m_s - wind_m_s);
}

Loads RigidFlight::loads(const Body& body, const RigidState& state, double time_s, double density_kg_m3,
                         const Vector3& wind_m_s) const {
  const Vector3 air_speed_m_s = through_air_m_s(state, wind_m_s);
  InAir in_air{.density_kg_m3 = density_kg_m3,
               .drag_area_m2 = parameters_.drag_area_m2,
               .centre_of_gravity_m = body.centre_of_gravity_m,
               .air_speed_m_s = air_speed_m_s,
               .rate_rad_s = state.rate_rad_s};
  if (parameters_.drag_over_mach.is_there() || parameters_.compressibility != Compressibility::none) {
    const double mach = length(air_speed_m_s) / parameters_.atmosphere.speed_of_sound_m_s(state.position_m.z);
    in_air.drag_area_m2 *= parameters_.drag_over_mach.at(mach);
    in_air.normal_force_factor = compressibility_factor(parameters_.compressibility, mach);
  }
  Loads all = air_loads(parameters_.airframe, in_air);
  all.force_n.x += body.thrust_n;
  all.moment_n_m = all.moment_n_m - body.jet_damping_n_m_s * state.rate_rad_s;
  if (push_area_m2_.y != 0.0 || push_area_m2_.z != 0.0) {
    const double axial_m_s = air_speed_m_s.x;
    const Vector3 push_n = (0.5 * density_kg_m3 * axial_m_s * axial_m_s) * push_area_m2_;
    all.force_n = all.force_n + push_n;
    all.moment_n_m = all.moment_n_m + cross({.x = body.centre_of_gravity_m - push_position_m_}, push_n);
  }
  if (parachute_s_) {
    add_parachute(all, body, air_speed_m_s, state.rate_rad_s, time_s, density_kg_m3);
  }
  return all;
}

void RigidFlight::add_parachute(Loads& loads, const Body& body, const Vector3& air_speed_m_s, const Vector3& rate_rad_s,
                                double time_s, double density_kg_m3) const {
  const Recovery& recovery = *parameters_.recovery;
  const double open = std::clamp((time_s - *parachute_s_) / recovery.opening_time_s, 0.0, 1.0);
  const Vector3 arm_m{.x = body.centre_of_gravity_m - recovery.position_m};
  const Vector3 speed_m_s = air_speed_m_s + cross(rate_rad_s, arm_m);
  const Vector3 pull_n = (-0.5 * density_kg_m3 * open * recovery.drag_area_m2 * length(speed_m_s)) * speed_m_s;
  loads.force_n = loads.force_n + pull_n;
  loads.moment_n_m = loads.moment_n_m + cross(arm_m, pull_n);
}

double RigidFlight::axial_in_guide_m_s2(const Loads& loads, const Body& body, double speed_m_s) const {
  const double per_kg = 1.0 / body.inertia.mass_kg;
  const double y_m_s2 = per_kg * loads.force_n.y + gravity_in_guide_m_s2_.y;
  const double z_m_s2 = per_kg * loads.force_n.z + gravity_in_guide_m_s2_.z;
  const double friction_m_s2 = parameters_.guide.friction * std::sqrt(y_m_s2 * y_m_s2 + z_m_s2 * z_m_s2);
  return per_kg * loads.force_n.x - (speed_m_s < 0.0 ? -friction_m_s2 : friction_m_s2);
}

void RigidFlight::advance_to(double time_s, double roll_rate_rad_s, const Vector3& wind_m_s) {
  switch (stage_) {
    case Stage::pad: wait_on_pad(time_s, wind_m_s); break;
    case Stage::guide: slide(time_s, wind_m_s); break;
    case Stage::free: fly(time_s, roll_rate_rad_s, wind_m_s); break;
    case Stage::landed: break;
  }
  wind_m_s_ = wind_m_s;
  if (!events_.burnout_s && time_s >= parameters_.motor.burnout_s() && burnt_per_n_s_ > 0.0) {
    events_.burnout_s = time_s;
  }
}

void RigidFlight::look(double time_s, double roll_rate_rad_s, double density_kg_m3, const Vector3& wind_m_s) {
  time_s_ = time_s;
  density_kg_m3_ = density_kg_m3;
  body_ = body_at(time_s);
  air_speed_m_s_ = through_air_m_s(state_, wind_m_s);
  const Loads all = loads(body_, state_, time_s, density_kg_m3, wind_m_s);
  if (stage_ == Stage::free) {
    now_ = rate_of_change(state_, all, body_.inertia, roll_rate_rad_s);
    specific_force_m_s2_ = (1.0 / body_.inertia.mass_kg) * all.force_n;
  } else {
    specific_force_m_s2_ = {.x = axial_in_guide_m_s2(all, body_, guide_speed_m_s_),
                            .y = -gravity_in_guide_m_s2_.y,
                            .z = -gravity_in_guide_m_s2_.z};
  }
}

void RigidFlight::wait_on_pad(double time_s, const Vector3& wind_m_s) {
  time_s_ = time_s;
  if (time_s < 0.0) {
    return;
  }
  look(time_s, 0.0, density_kg_m3_, wind_m_s);
  if (specific_force_m_s2_.x > -gravity_in_guide_m_s2_.x) {
    stage_ = Stage::guide;
    events_.liftoff_s = events_.liftoff_s.value_or(time_s);
  } else {
    specific_force_m_s2_.x = -gravity_in_guide_m_s2_.x;
  }
}

void RigidFlight::slide(double time_s, const Vector3& wind_m_s) {
  const double dt_s = time_s - time_s_;
  if (!(dt_s > 0.0)) {
    return;
  }
  const Vector3 axis = rotated(state_.attitude, {.x = 1.0});
  const double middle_time_s = time_s_ + 0.5 * dt_s;
  const double middle_speed_m_s = guide_speed_m_s_ + 0.5 * dt_s * (specific_force_m_s2_.x + gravity_in_guide_m_s2_.x);
  const double density_kg_m3 = density_.at((distance_m_ + dt_s * guide_speed_m_s_) * axis.z);
  const Body body = body_at(middle_time_s);
  RigidState middle = state_;
  middle.velocity_m_s = middle_speed_m_s * axis;
  const Loads all =
      loads(body, middle, middle_time_s, 0.5 * (density_kg_m3_ + density_kg_m3), 0.5 * (wind_m_s_ + wind_m_s));
  distance_m_ += dt_s * middle_speed_m_s;
  guide_speed_m_s_ += dt_s * (axial_in_guide_m_s2(all, body, middle_speed_m_s) + gravity_in_guide_m_s2_.x);
  state_.position_m = distance_m_ * axis;
  state_.velocity_m_s = guide_speed_m_s_ * axis;
  highest_.look(time_s, state_.position_m.z, guide_speed_m_s_, events_.apogee_s);
  if (guide_speed_m_s_ < 0.0) {
    first_sank_s_ = first_sank_s_.value_or(time_s);
    if (distance_m_ <= 0.0) {
      time_s_ = time_s;
      come_to_rest();
      return;
    }
  }
  if (distance_m_ >= parameters_.guide_length_m) {
    stage_ = Stage::free;
    state_.rate_rad_s.z = -parameters_.guide.tip_off_rad_s;
  }
  look(time_s, 0.0, density_kg_m3, wind_m_s);
}

void RigidFlight::fly(double time_s, double roll_rate_rad_s, const Vector3& wind_m_s) {
  const double dt_s = time_s - time_s_;
  if (!(dt_s > 0.0)) {
    return;
  }
  // As in Ascent: where the speed at the start leads to is near enough for the density.
  const double density_kg_m3 = density_.at(state_.position_m.z + dt_s * state_.velocity_m_s.z);
  const double middle_density_kg_m3 = 0.5 * (density_kg_m3_ + density_kg_m3);
  const Vector3 middle_wind_m_s = 0.5 * (wind_m_s_ + wind_m_s);
  state_ = stepped(state_, now_, dt_s, [&](const RigidState& middle, double after_s) {
    const Body body = body_at(time_s_ + after_s);
    return rate_of_change(middle, loads(body, middle, time_s_ + after_s, middle_density_kg_m3, middle_wind_m_s),
                          body.inertia, roll_rate_rad_s);
  });
  twist_.follow(state_.attitude);
  highest_.look(time_s, state_.position_m.z, state_.velocity_m_s.z, events_.apogee_s);
  if (state_.velocity_m_s.z < 0.0) {
    first_sank_s_ = first_sank_s_.value_or(time_s);
    if (state_.position_m.z <= 0.0) {
      time_s_ = time_s;
      come_to_rest();
      return;
    }
  }
  if (has_parachute_to_open() && first_sank_s_ && time_s >= *first_sank_s_ + parameters_.recovery->delay_s) {
    parachute_s_ = time_s;
  }
  look(time_s, roll_rate_rad_s, density_kg_m3, wind_m_s);
}

void RigidFlight::come_to_rest() {
  const bool was_in_guide = stage_ == Stage::guide;
  state_.position_m.z = 0.0;
  state_.velocity_m_s = {};
  state_.rate_rad_s = {};
  now_ = {};
  air_speed_m_s_ = {};
  specific_force_m_s2_ = rotated_back(state_.attitude, -1.0 * gravity_vector_m_s2);
  if (was_in_guide && time_s_ < parameters_.motor.burnout_s()) {
    // A motor that stutters let it hop: it stands on the pad again, and the flight is still to come.
    distance_m_ = 0.0;
    guide_speed_m_s_ = 0.0;
    state_.position_m = {};
    stage_ = Stage::pad;
    first_sank_s_.reset();
  } else {
    stage_ = Stage::landed;
    events_.landing_s = time_s_;
  }
}

}  // namespace fantail::sim
