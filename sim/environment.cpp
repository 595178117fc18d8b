// SPDX-License-Identifier: MIT
#include "sim/environment.hpp"

namespace fantail::sim {
namespace {

/// What a rolling rocket feels of a motion that is given in its frame that does not roll.
BodyMotion rolling(const BodyMotion& frame, const RollState& roll, double roll_acceleration_rad_s2) {
  const auto [sine, cosine] = sine_cosine(roll.angle_rad);
  // The body is turned against the frame.
  const auto in_body = [&](const Vector3& v) {
    return Vector3{v.x, cosine * v.y + sine * v.z, cosine * v.z - sine * v.y};
  };
  const Vector3 across = in_body(frame.rate_rad_s);
  const Vector3 turning = in_body(frame.angular_acceleration_rad_s2);
  return {.specific_force_m_s2 = in_body(frame.specific_force_m_s2),
          .rate_rad_s = {.x = roll.rate_rad_s, .y = across.y, .z = across.z},
          // The body sees the rates of the frame turn backwards as it rolls.
          .angular_acceleration_rad_s2 = {.x = roll_acceleration_rad_s2,
                                          .y = turning.y + roll.rate_rad_s * across.z,
                                          .z = turning.z - roll.rate_rad_s * across.y}};
}

}  // namespace

Environment::Environment(const Scenario& scenario, Random turbulence)
    : scenario_{scenario},
      guide_length_m_{scenario.guide.length_m.value_or(static_cast<double>(scenario.plan.guide.length_m))},
      turbulence_{turbulence},
      time_s_{-scenario.pad_time_s} {
  const Vehicle& vehicle = scenario.vehicle;
  if (scenario.surroundings == Surroundings::tunnel) {
    fan_to_come_ = scenario.fan_programme;
    fan_rpm_ = scenario.tunnel.fan_rpm;
    tunnel_.emplace(scenario.tunnel, turbulence_.gaussian());
    if (scenario.pin) {
      pinned_.emplace(*scenario.pin, *vehicle.airframe, vehicle.mass_kg);
    }
  } else if (scenario.surroundings == Surroundings::gimbal) {
    tunnel_.emplace(WindTunnelParameters{.fan_rpm = 0.0});
    gimbal_.emplace(scenario.hand_turns,
                    scenario.gimbal_friction_n_m
                        ? std::optional{FreeTurning{
                              .roll_inertia_kg_m2 = vehicle.roll_plant.inertia_kg_m2,
                              .transverse_inertia_kg_m2 = vehicle.airframe.value().at_liftoff.transverse_inertia_kg_m2,
                              .friction_n_m = *scenario.gimbal_friction_n_m}}
                        : std::nullopt);
  } else if (scenario.path) {
    prescribed_.emplace(*scenario.path);
  } else if (scenario.motion == FlightMotion::six_dof) {
    flight_.emplace(RigidFlightParameters{.mass_kg = vehicle.mass_kg,
                                          .drag_area_m2 = vehicle.drag_area_m2,
                                          .roll_inertia_kg_m2 = vehicle.roll_plant.inertia_kg_m2,
                                          .airframe = vehicle.airframe.value(),
                                          .guide = scenario.guide,
                                          .guide_length_m = guide_length_m_,
                                          .atmosphere = scenario.atmosphere,
                                          .motor = vehicle.motor,
                                          .recovery = vehicle.recovery,
                                          .drag_over_mach = vehicle.drag_over_mach,
                                          .compressibility = vehicle.compressibility});
    wind_.emplace(scenario.wind, turbulence_);
  } else {
    ascent_.emplace(AscentParameters{.mass_kg = vehicle.mass_kg,
                                     .drag_area_m2 = vehicle.drag_area_m2,
                                     .guide_tilt_rad = scenario.guide.tilt_rad,
                                     .guide_length_m = guide_length_m_,
                                     .atmosphere = scenario.atmosphere,
                                     .motor = vehicle.motor,
                                     .drag_over_mach = vehicle.drag_over_mach});
  }
}

void Environment::advance_to(double time_s, double roll_rate_rad_s) {
  if (ascent_) {
    ascent_->advance_to(time_s);
  } else if (prescribed_) {
    prescribed_->advance_to(time_s);
  } else if (flight_) {
    flight_->advance_to(time_s, roll_rate_rad_s,
                        wind_->step(time_s, time_s - time_s_, flight_->height_m(), length(flight_->air_speed_m_s())));
  } else if (time_s > time_s_) {
    follow_fan_programme();
    const double speed_m_s = tunnel_->step(time_s - time_s_, turbulence_.gaussian());
    if (pinned_) {
      pinned_->step(time_s, time_s - time_s_, tunnel_->density_kg_m3(), speed_m_s);
    }
  }
  time_s_ = time_s;
}

void Environment::push_aside(const Vector3& area_m2, double position_m, double roll_angle_rad) {
  if (flight_) {
    const auto [sine, cosine] = sine_cosine(roll_angle_rad);
    flight_->push_aside({.y = cosine * area_m2.y - sine * area_m2.z, .z = sine * area_m2.y + cosine * area_m2.z},
                        position_m);
  }
}

std::optional<RollState> Environment::turn_by_hand(double since_power_up_s, double dt_s) {
  if (!gimbal_) {
    return std::nullopt;
  }
  gimbal_->step(since_power_up_s, dt_s);
  return RollState{.angle_rad = gimbal_->roll_angle_rad(), .rate_rad_s = gimbal_->motion().rate_rad_s.x};
}

void Environment::follow_fan_programme() {
  constexpr double clock_tolerance_s = 1e-7;  // ticks are whole microseconds, seconds are not exact
  while (!fan_to_come_.empty() && fan_to_come_.front().time_s <= time_s_ + clock_tolerance_s) {
    fan_rpm_ = fan_to_come_.front().fan_rpm;
    tunnel_->set_fan_rpm(fan_rpm_);
    fan_to_come_ = fan_to_come_.subspan(1);
  }
}

double Environment::compressibility_here() const {
  return compressibility_factor(scenario_.vehicle.compressibility,
                                speed_m_s() / scenario_.atmosphere.speed_of_sound_m_s(height_m()));
}

bool Environment::is_clear_of_guide() const {
  if (prescribed_) {
    return prescribed_->events().liftoff_s &&
           prescribed_->height_m() >= guide_length_m_ * sine_cosine(scenario_.guide.tilt_rad).cosine;
  }
  return flight_ ? flight_->is_clear_of_guide() : ascent_ && ascent_->distance_m() >= guide_length_m_;
}

bool Environment::is_on_ground() const {
  if (prescribed_) {
    return prescribed_->is_on_ground();
  }
  return flight_ ? flight_->is_on_ground() : ascent_ && ascent_->distance_m() <= 0.0;
}

bool Environment::is_past_apogee() const {
  const AscentEvents& events = ascent_events();
  if (prescribed_) {
    return events.apogee_s && (events.burnout_s || !scenario_.path->burnout_s);
  }
  const double up_m_s = flight_ ? flight_->state().velocity_m_s.z : ascent_->speed_m_s();
  return events.burnout_s && (up_m_s < 0.0 || is_on_ground());
}

bool Environment::can_roll() const {
  if (prescribed_) {
    return scenario_.guide.roll == GuideRoll::free || is_clear_of_guide();
  }
  return flight_ ? !flight_->guide_holds_roll() : !pinned_ && !gimbal_;
}

std::optional<Path> Environment::path() const {
  if (prescribed_) {
    return Path{
        .position_m = {.x = prescribed_->across_m(), .z = prescribed_->height_m()},
        .velocity_m_s = {.x = prescribed_->across_m_s(), .z = prescribed_->up_m_s()},
        .tilt_rad = prescribed_->tilt_rad(),
        .tilt_from_guide_rad = std::abs(prescribed_->tilt_rad() - scenario_.path.value().samples.front().tilt_rad),
        .angle_of_attack_rad = 0.0};
  }
  if (!flight_) {
    return std::nullopt;
  }
  return Path{.position_m = flight_->state().position_m,
              .velocity_m_s = flight_->state().velocity_m_s,
              .tilt_rad = flight_->tilt_rad(),
              .tilt_from_guide_rad = flight_->tilt_from_guide_rad(),
              .angle_of_attack_rad = angle_of_attack_rad(flight_->air_speed_m_s())};
}

std::optional<BurningRocket> Environment::burning() const {
  if (!prescribed_ || scenario_.motion != FlightMotion::six_dof) {
    return std::nullopt;
  }
  const Vehicle& vehicle = scenario_.vehicle;
  const double impulse_n_s = vehicle.motor.impulse_n_s();
  return burning_rocket(vehicle.airframe.value(),
                        {.mass_kg = vehicle.mass_kg,
                         .propellant_kg = vehicle.motor.propellant_kg(),
                         .roll_inertia_kg_m2 = vehicle.roll_plant.inertia_kg_m2},
                        impulse_n_s > 0.0 ? vehicle.motor.at(time_s_).impulse_n_s / impulse_n_s : 0.0);
}

std::optional<double> Environment::roll_inertia_kg_m2() const {
  if (!prescribed_) {
    return flight_ ? std::optional{flight_->roll_inertia_kg_m2()} : std::nullopt;
  }
  const auto rocket = burning();
  return rocket ? std::optional{rocket->inertia.roll_kg_m2} : std::nullopt;
}

std::optional<double> Environment::centre_of_gravity_m() const {
  if (const auto rocket = burning()) {
    return rocket->centre_of_gravity_m;
  }
  // The pins are what a pinned rocket turns about.
  return flight_   ? std::optional{flight_->centre_of_gravity_m()}
         : pinned_ ? std::optional{pinned_->pin_position_m()}
                   : std::nullopt;
}

BodyMotion Environment::motion(const RollState& roll, double roll_acceleration_rad_s2) const {
  if (pinned_) {
    return pinned_->motion();
  }
  if (gimbal_) {
    return gimbal_->motion();
  }
  if (flight_) {
    return rolling({.specific_force_m_s2 = flight_->specific_force_m_s2(),
                    .rate_rad_s = flight_->state().rate_rad_s,
                    .angular_acceleration_rad_s2 = flight_->angular_acceleration_rad_s2()},
                   roll, roll_acceleration_rad_s2);
  }
  if (prescribed_) {
    return rolling({.specific_force_m_s2 = prescribed_->specific_force_m_s2(),
                    .rate_rad_s = prescribed_->rate_rad_s(),
                    .angular_acceleration_rad_s2 = prescribed_->angular_acceleration_rad_s2()},
                   roll, roll_acceleration_rad_s2);
  }
  BodyMotion motion{.specific_force_m_s2 = {.x = ascent_ ? ascent_->axial_specific_force_m_s2() : gravity_m_s2},
                    .rate_rad_s = {.x = roll.rate_rad_s},
                    .angular_acceleration_rad_s2 = {.x = roll_acceleration_rad_s2}};
  if (ascent_) {
    if (const double lateral_m_s2 = ascent_->lateral_specific_force_m_s2(); lateral_m_s2 != 0.0) {
      // The guide leans towards one side of the rocket; rolling turns that side away from where the sensor's axes
      // point.
      const SineCosine turned = sine_cosine(roll.angle_rad);
      motion.specific_force_m_s2.y = lateral_m_s2 * turned.cosine;
      motion.specific_force_m_s2.z = -lateral_m_s2 * turned.sine;
    }
  }
  return motion;
}

}  // namespace fantail::sim
