// SPDX-License-Identifier: MIT
#include "hardover/study.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "flight/model_end.hpp"
#include "fly/describe.hpp"
#include "fly/fly_scenario.hpp"
#include "fly/to_ground.hpp"
#include "runs/runner.hpp"
#include "sim/atmosphere.hpp"
#include "sim/rotation.hpp"
#include "sim/world.hpp"
#include "text/error.hpp"

namespace fantail::hardover {
namespace {

constexpr std::uint64_t flights_of_a_part = 8;

struct Flown {
  std::vector<sim::Vector3> velocity_m_s;  ///< earth, of each tick
  std::vector<double> push_m2;             ///< side force over the dynamic pressure
  std::vector<double> pressure_pa;
  std::vector<double> angle_of_attack_rad;
  std::vector<double> air_speed_m_s;
  std::vector<double> roll_rate_rad_s;
  std::vector<double> roll_angle_rad;
  double clear_s = 0.0;  ///< after ignition
  double apogee_s = 0.0;
  double apogee_m = 0.0;
  sim::Vector3 apogee_at_m;
  sim::Vector3 end_at_m;  ///< where the vectors end
  std::optional<sim::Vector3> landing_at_m{};
};

/// v t + h = g t^2 / 2 at the ground.
double fall_from_guide_m(const Flown& flown) {
  const sim::Vector3& at_m = flown.end_at_m;
  const sim::Vector3& v_m_s = flown.velocity_m_s.back();
  const double t_s =
      (v_m_s.z + std::sqrt(v_m_s.z * v_m_s.z + 2.0 * sim::gravity_m_s2 * std::max(0.0, at_m.z))) / sim::gravity_m_s2;
  return std::hypot(at_m.x + t_s * v_m_s.x, at_m.y + t_s * v_m_s.y);
}

/// The vectors end at apogee, or at burn-out where that is later.
Flown flown(const sim::Scenario& scenario) {
  fly::ToGround flight{scenario};
  const sim::World& world = flight.world();
  Flown out;
  while (flight.tick()) {
    if (flight.is_ascent()) {
      const sim::Path path = world.path().value();
      const sim::Truth truth = world.truth();
      const sim::Vector3 across = world.canards_across_rad();
      const double density_kg_m3 = scenario.atmosphere.density_kg_m3(path.position_m.z);
      out.velocity_m_s.push_back(path.velocity_m_s);
      out.end_at_m = path.position_m;
      out.push_m2.push_back(*scenario.vehicle.canard_air.side_area_m2 * length(across));
      out.pressure_pa.push_back(0.5 * density_kg_m3 * truth.speed_m_s * truth.speed_m_s);
      out.angle_of_attack_rad.push_back(path.angle_of_attack_rad);
      out.air_speed_m_s.push_back(truth.speed_m_s);
      out.roll_rate_rad_s.push_back(truth.roll_rate_rad_s);
      out.roll_angle_rad.push_back(truth.roll_angle_rad);
      if (path.position_m.z > out.apogee_m) {
        out.apogee_m = path.position_m.z;
        out.apogee_at_m = path.position_m;
      }
    }
  }
  out.landing_at_m = flight.landing_m();
  const sim::World::Events& events = world.events();
  if (!events.guide_clear || !events.apogee) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      scenario.name + ": the rocket does not leave its guide, or it does not reach an apogee"};
  }
  out.clear_s = flight.after_ignition_s(*events.guide_clear);
  out.apogee_s = flight.after_ignition_s(*events.apogee);
  return out;
}

double angle_between_rad(const sim::Vector3& a, const sim::Vector3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

Effect effect_of(const Flown& failed, const Flown& sound, Effect effect, const Study& study) {
  const auto from = static_cast<std::size_t>(std::lround(1e3 * effect.from_s));
  // Behind apogee it falls, whatever a canard does.
  const std::size_t until =
      std::min(failed.velocity_m_s.size(), static_cast<std::size_t>(std::lround(1e3 * failed.apogee_s)));
  for (std::size_t i = from; i < until; ++i) {
    if (const double force_n = failed.push_m2[i] * failed.pressure_pa[i]; force_n > effect.side_force_n) {
      effect.side_force_n = force_n;
      effect.pressure_pa = failed.pressure_pa[i];
    }
    effect.roll_rate_rad_s = std::max(effect.roll_rate_rad_s, std::abs(failed.roll_rate_rad_s[i]));
    if (i < sound.roll_angle_rad.size()) {
      effect.rolled_rad = std::max(effect.rolled_rad, std::abs(failed.roll_angle_rad[i] - sound.roll_angle_rad[i]));
    }
    if (failed.air_speed_m_s[i] < slowest_m_s) {
      continue;
    }
    effect.angle_of_attack_rad = std::max(effect.angle_of_attack_rad, std::optional{failed.angle_of_attack_rad[i]});
    if (i < sound.velocity_m_s.size() && length(sound.velocity_m_s[i]) >= slowest_m_s) {
      effect.turned_rad = std::max(effect.turned_rad, angle_between_rad(failed.velocity_m_s[i], sound.velocity_m_s[i]));
    }
  }
  effect.apogee_m = failed.apogee_m;
  effect.fall_from_guide_m = fall_from_guide_m(failed);
  effect.apogee_east_m = -failed.apogee_at_m.y;
  effect.apogee_north_m = failed.apogee_at_m.x;
  effect.away_m = std::hypot(failed.apogee_at_m.x - sound.apogee_at_m.x, failed.apogee_at_m.y - sound.apogee_at_m.y);
  if (failed.landing_at_m) {
    effect.landing_east_m = -failed.landing_at_m->y;
    effect.landing_north_m = failed.landing_at_m->x;
    if (sound.landing_at_m) {
      effect.landing_away_m =
          std::hypot(failed.landing_at_m->x - sound.landing_at_m->x, failed.landing_at_m->y - sound.landing_at_m->y);
    }
  }
  if (study.options.coupler_m) {
    effect.moment_n_m = effect.side_force_n * std::max(0.0, *study.options.coupler_m - study.position_m);
  }
  return effect;
}

sim::Fault fault_of(const Effect& effect, Failure failure) {
  sim::Fault fault{.device = sim::Device::servo, .canard = effect.canard, .from_s = effect.from_s};
  if (failure == Failure::cut_pulses) {
    fault.how = sim::Behaviour::cut;
    fault.until_s = effect.from_s + cut_s;
  } else {
    fault.how = sim::GearFault{sim::ServoFault::stuck, effect.stop_rad};
  }
  return fault;
}

std::vector<double> stops_rad(const Study& study) {
  return study.options.failure == Failure::hard_over ? std::vector{study.stop_rad, -study.stop_rad} : std::vector{0.0};
}

/// The canards' own numbers, or those that follow from the shape.
void complete(sim::Scenario& scenario) {
  require_free_flight(scenario);
  if (!scenario.vehicle.airframe) {
    throw text::Error{
        text::ErrorKind::bad_configuration,
        scenario.vehicle.name + " has no section [airframe], which a flight in six degrees of freedom needs"};
  }
  sim::CanardAerodynamics& air = scenario.vehicle.canard_air;
  if (!air.side_area_m2) {
    const auto side = fly::canard_side(scenario.vehicle);
    if (!side) {
      throw text::Error{text::ErrorKind::bad_configuration,
                        scenario.vehicle.name +
                            " has no side force of its canards; give aerodynamics.canard_side_area_m2 and "
                            "canard_position_m, or the sections [shape] and [canard_fins]"};
    }
    air.side_area_m2 = side->area_m2;
    air.position_m = side->position_m;
  }
  scenario.motion = sim::FlightMotion::six_dof;
}

void refuse_station_outside(const sim::Vehicle& vehicle, const std::optional<double>& coupler_m) {
  const double length_m = vehicle.airframe->length_m;
  if (coupler_m && !(*coupler_m >= 0.0 && *coupler_m <= length_m)) {
    throw text::Error{
        text::ErrorKind::bad_configuration,
        fmt::format("the coupler at {:g} m from the tip of the nose lies outside {}; allowed: 0 to {:g} m", *coupler_m,
                    vehicle.name, length_m)};
  }
}

}  // namespace

void require_free_flight(const sim::Scenario& scenario) {
  if (scenario.surroundings != sim::Surroundings::flight || scenario.path) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      scenario.name + " is not a free flight; allowed: a scenario that launches a rocket"};
  }
}

Study fly(sim::Scenario scenario, const Options& options,
          const std::function<void(std::size_t done, std::size_t of)>& look) {
  complete(scenario);
  refuse_station_outside(scenario.vehicle, options.coupler_m);
  const Flown sound = flown(scenario);
  Study study{
      .scenario = scenario.name,
      .vehicle = scenario.vehicle.name,
      .plan = scenario.plan_name,
      .seed = scenario.seed,
      .policy = scenario.plan.run.canard_fault,
      .has_gate = scenario.plan.dormancy.until != core::DormantUntil::guide,
      .side_area_m2 = *scenario.vehicle.canard_air.side_area_m2,
      .position_m = *scenario.vehicle.canard_air.position_m,
      .stop_rad = scenario.vehicle.servo.stop_rad,
      .stall_rad = scenario.vehicle.canard_air.stall_rad,
      .first_s = sound.clear_s,
      .last_s = sound.apogee_s,
      .sound_apogee_m = sound.apogee_m,
      .sound_apogee_east_m = -sound.apogee_at_m.y,
      .sound_apogee_north_m = sound.apogee_at_m.x,
      .sound_landing_east_m = {},
      .sound_landing_north_m = {},
      .has_parachute = fly::has_parachute(scenario.vehicle),
      .sound_fall_from_guide_m = fall_from_guide_m(sound),
      .sound_angle_of_attack_rad = {},
      .sound_roll_rate_rad_s = 0.0,
      .beyond_model = flight::how_far_beyond(fly::fly_without_rows(scenario, [](const auto&, const auto&) {}).extremes),
      .options = options};
  if (sound.landing_at_m) {
    study.sound_landing_east_m = -sound.landing_at_m->y;
    study.sound_landing_north_m = sound.landing_at_m->x;
  }
  for (std::size_t i = static_cast<std::size_t>(std::lround(1e3 * sound.clear_s)); i < sound.air_speed_m_s.size();
       ++i) {
    study.sound_roll_rate_rad_s = std::max(study.sound_roll_rate_rad_s, std::abs(sound.roll_rate_rad_s[i]));
    if (sound.air_speed_m_s[i] >= slowest_m_s) {
      study.sound_angle_of_attack_rad =
          std::max(study.sound_angle_of_attack_rad, std::optional{sound.angle_of_attack_rad[i]});
    }
  }
  const auto instant_s = [&](std::size_t k) { return sound.clear_s + static_cast<double>(k) * options.step_s; };
  while (instant_s(study.instants) < sound.apogee_s) {
    ++study.instants;
  }
  for (std::size_t canard = 0; canard < scenario.vehicle.canards.size(); ++canard) {
    for (const double stop_rad : stops_rad(study)) {
      for (std::size_t k = 0; k < study.instants; ++k) {
        study.effects.push_back({.canard = canard, .stop_rad = stop_rad, .from_s = instant_s(k)});
      }
    }
  }
  const std::vector<Effect> failures = study.effects;
  const auto fly_one = [&](std::uint64_t i) {
    sim::Scenario broken = scenario;
    broken.faults.push_back(fault_of(failures[i], options.failure));
    return effect_of(flown(broken), sound, failures[i], study);
  };
  runs::run(runs::rows_into<Effect>(study.effects, flights_of_a_part, "", fly_one), options.kept, options.threads,
            [&](std::uint64_t done) { look(done, failures.size()); });
  for (Effect& effect : study.effects) {
    if (effect.landing_east_m && effect.landing_north_m) {
      effect.landing_from_guide_m = std::hypot(*effect.landing_east_m, *effect.landing_north_m);
    }
  }
  return study;
}

}  // namespace fantail::hardover
