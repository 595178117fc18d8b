// SPDX-License-Identifier: MIT
#include "fly/fly_scenario.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <fmt/core.h>

#include "airframe/model/build_up.hpp"
#include "fly/fault_text.hpp"
#include "fly/model_limits.hpp"
#include "replies/sentence.hpp"
#include "sim/deflection_range.hpp"
#include "sim/nearest_tick.hpp"
#include "sim/units.hpp"
#include "sim/world.hpp"

namespace fantail::fly {
namespace {

double in_seconds(core::Microseconds time) { return 1e-6 * static_cast<double>(time.count()); }

std::optional<double> in_seconds(const std::optional<core::Microseconds>& time) {
  return time ? std::optional{in_seconds(*time)} : std::nullopt;
}

flight::Truth to_report(const sim::Truth& truth) {
  return {.roll_angle_rad = truth.roll_angle_rad,
          .roll_rate_rad_s = truth.roll_rate_rad_s,
          .canard_rad = truth.canard_rad,
          .height_m = truth.height_m,
          .speed_m_s = truth.speed_m_s,
          .disturbance_rad = truth.disturbance_rad};
}

flight::PathPoint to_report(const sim::Path& path, double time_s) {
  const sim::Vector3& at = path.position_m;
  const sim::Vector3& speed = path.velocity_m_s;
  return {.time_s = time_s,
          .north_m = at.x,
          .east_m = -at.y,
          .height_m = at.z,
          .north_m_s = speed.x,
          .east_m_s = -speed.y,
          .up_m_s = speed.z,
          .tilt_rad = path.tilt_rad,
          .angle_of_attack_rad = path.angle_of_attack_rad};
}

/// What holds the rocket stands still there, so that the specific force it feels is the vertical.
flight::TurnPoint turn_point(const sim::World& world, const core::TickRecord& record, double time_s) {
  const sim::BodyMotion motion = world.motion();
  const sim::Vector3& felt = motion.specific_force_m_s2;
  const hal::sim::WorldSide& hardware = world.hardware();
  const auto gyro = [&](std::size_t axis) {
    return static_cast<double>(hardware.imu_scale.rate_rad_s) * hardware.imu.rate[axis];
  };
  return {.time_s = time_s,
          .true_roll_rate_rad_s = motion.rate_rad_s.x,
          .true_pitch_rate_rad_s = motion.rate_rad_s.y,
          .true_yaw_rate_rad_s = motion.rate_rad_s.z,
          .true_tilt_rad = std::atan2(std::hypot(felt.y, felt.z), felt.x),
          .gyro_roll_rate_rad_s = gyro(0),
          .gyro_pitch_rate_rad_s = gyro(1),
          .gyro_yaw_rate_rad_s = gyro(2),
          .tilt_rad = static_cast<double>(record.motion.tilt.radians())};
}

std::vector<flight::Outage> outages(const sim::World& world) {
  std::vector<flight::Outage> all;
  for (const sim::World::Gap& gap : world.gaps()) {
    all.push_back({.from_s = in_seconds(gap.from - sim::tick_time),
                   .to_s = in_seconds(gap.to),
                   .cause = std::string{hal::name(gap.cause)},
                   .resumed = gap.resumed});
  }
  return all;
}

std::string static_margins(const sim::Airframe& airframe) {
  const double full_m = static_margin_m(airframe, airframe.at_liftoff);
  const double empty_m = static_margin_m(airframe, airframe.after_burnout);
  return fmt::format("Static margin: {:.0f} mm ({:.1f} calibres) at lift-off, {:.0f} mm ({:.1f}) after burn-out.",
                     1e3 * full_m, full_m / airframe.diameter_m, 1e3 * empty_m, empty_m / airframe.diameter_m);
}

/// The sentences of vehicle and scenario are anybody's words: nobody can tell which of them are about the path.
void limit_to_path(std::vector<std::string>& sentences) {
  if (const std::size_t count = sentences.size(); count > 0) {
    sentences.insert(sentences.begin(),
                     fmt::format("The next {} of vehicle and scenario. The path is that of the trajectory, whatever "
                                 "they say of thrust, drag, mass, stability, wind or parachute.",
                                 count == 1 ? "sentence is" : fmt::format("{} sentences are", count)));
  }
}

// The roll torque that the vehicle states says how strong a canard is, its shape where it stands.
std::optional<double> side_moment_m3(const sim::Vehicle& vehicle) {
  if (!vehicle.geometry || !vehicle.geometry->canards || !vehicle.airframe) {
    return {};
  }
  const airframe::model::BuildUp built = airframe::model::build_up(vehicle);
  const auto canards = std::ranges::find(built.parts, "canards", &airframe::model::Part::name);
  if (canards == built.parts.end() || !built.canard_arm_m) {
    return {};
  }
  const double roll_arm_m = vehicle.canard_air.arm_m.value_or(*built.canard_arm_m);
  const double one_canard_m2 = vehicle.roll_plant.reference_area_m2 * vehicle.roll_plant.torque_m / (4.0 * roll_arm_m);
  return one_canard_m2 * std::abs(vehicle.airframe->after_burnout.centre_of_gravity_m - canards->position_m);
}

flight::Flight describe(const sim::Scenario& scenario) {
  flight::Flight flight;
  flight.scenario = scenario.name;
  flight.vehicle = scenario.vehicle.name;
  flight.airframe = {.vehicle = scenario.vehicle.name,
                     .vehicle_file = scenario.vehicle_name,
                     .roll_inertia_kg_m2 = scenario.vehicle.roll_plant.inertia_kg_m2,
                     .reference_area_m2 = scenario.vehicle.roll_plant.reference_area_m2};
  flight.plan_name = scenario.plan_name;
  flight.version = FANTAIL_VERSION;
  flight.seed = scenario.seed;
  flight.tunnel = scenario.surroundings != sim::Surroundings::flight;
  flight.plan = scenario.plan;
  const sim::DeflectionRange reach = sim::deflection_range(scenario);
  flight.canard_reach = {.lowest_rad = reach.lowest_rad, .highest_rad = reach.highest_rad};
  flight.left_by_fins = sim::left_by_fins(scenario.vehicle.canard_air);
  flight.side_moment_m3 = side_moment_m3(scenario.vehicle);
  for (const auto* sentences :
       {&scenario.vehicle.warnings, &scenario.warnings, &scenario.vehicle.assumed, &scenario.assumed}) {
    flight.notes.insert(flight.notes.end(), sentences->begin(), sentences->end());
  }
  if (scenario.path) {
    flight.path_frame = flight::PathFrame::plane;
    limit_to_path(flight.notes);
  }
  if (scenario.motion == sim::FlightMotion::six_dof && !scenario.path) {
    const auto& assumed = scenario.vehicle.airframe_assumed;
    flight.notes.insert(flight.notes.end(), assumed.begin(), assumed.end());
    flight.notes.push_back(static_margins(scenario.vehicle.airframe.value()));
  }
  for (const sim::Fault& fault : scenario.faults) {
    flight.notes.push_back(fault_text(fault, scenario));
  }
  if (std::ranges::any_of(scenario.faults, [](const sim::Fault& fault) {
        return sim::is_of_canard(fault.kind) && !sim::is_there_at_liftoff(fault);
      })) {
    flight.notes.emplace_back(
        "Authority and stability margins are those at lift-off, without the canard faults that "
        "began later.");
  }
  if (scenario.log_period_s > 0.001) {
    flight.notes.push_back(fmt::format("flight.csv has a row every {:g} s instead of every millisecond{}.",
                                       scenario.log_period_s,
                                       flight.tunnel ? ", and the figures are made of these rows" : ""));
  }
  return flight;
}

std::string why_not_armed(const sim::World& world, const sim::Scenario& scenario) {
  constexpr double self_test_s = 7.5;
  const auto refusal = world.refusal_to_arm();
  const double left_s = scenario.pad_time_s - scenario.arm_time_s;
  // A self-test that the launch interrupts fails because the rocket does not stand still.
  if (!refusal || (left_s < self_test_s && refusal->failure == protocol::SelfTestFailure::moved)) {
    return fmt::format(
        "its self-test takes about seven seconds, and {:g} s after it began {} (timing.arm_time_s, timing.pad_time_s)",
        left_s,
        scenario.surroundings != sim::Surroundings::flight ? "came the start command" : "the motor was ignited");
  }
  return "the avionics refused to be armed: " + (refusal->refusal != protocol::ArmRefusal::none
                                                     ? replies::sentence(refusal->refusal)
                                                     : replies::sentence(refusal->failure, refusal->canard));
}

void keep_log(flight::Flight& flight, const sim::World& world, bool was_armed) {
  const std::span<const std::byte> recorded = world.recorded();
  flight.log.assign(recorded.begin(), recorded.end());
  if (flight.log.empty()) {
    flight.notes.push_back(fmt::format("The avionics recorded nothing, so there is no flight.ftl: it was never {}.",
                                       !was_armed      ? "armed"
                                       : flight.tunnel ? "started"
                                                       : "launched, as far as it could tell"));
  } else if (world.record_is_full()) {
    flight.notes.emplace_back("flight.ftl ends before the run does: the flash of the avionics was full.");
  }
}

}  // namespace

std::optional<double> expected_length_s(const sim::Scenario& scenario) {
  if (scenario.surroundings == sim::Surroundings::flight) {
    return std::nullopt;
  }
  return scenario.pad_time_s + in_seconds(scenario.plan.run.control_time) + scenario.time_after_end_s;
}

flight::Flight fly_scenario(const sim::Scenario& scenario, const Look& look, const Observe& observe, Log log,
                            const sim::MakeFlightComputer& make) {
  constexpr std::int64_t ticks_between_looks = 1024;
  constexpr std::int64_t ticks_between_points = 10;
  flight::Flight flight = describe(scenario);
  // A launch is judged by every tick. In the tunnel a run of a quarter of an hour would fill the memory.
  const std::int64_t ticks_per_line = std::llround(scenario.log_period_s * 1e3);
  const std::int64_t ticks_per_row = flight.tunnel ? ticks_per_line : 1;
  flight.rows_per_line = static_cast<std::size_t>(ticks_per_line / ticks_per_row);
  sim::World world{scenario, log == Log::kept ? sim::World::large_flash : sim::World::small_flash, make};
  const bool is_held = scenario.surroundings == sim::Surroundings::gimbal || scenario.pin;
  bool was_armed = false;
  for (std::int64_t ticks = 0; !world.over(); ++ticks) {
    const core::TickRecord& record = world.tick();
    if (world.is_down()) {
      world.advance();
      continue;
    }
    if (observe) {
      observe(record);
    }
    was_armed = was_armed || record.phase != core::Phase::safe;
    const double time_s = in_seconds(world.now());
    if (ticks % ticks_per_row == 0) {
      flight::add_tick(flight, record, time_s, to_report(world.truth()));
    } else {
      flight::note_tick(flight, record, time_s);
    }
    if (ticks % ticks_between_points == 0) {
      if (const auto path = world.path()) {
        flight.path.push_back(to_report(*path, time_s));
      }
      if (is_held) {
        flight.turning.push_back(turn_point(world, record, time_s));
      }
    }
    if (const auto reading = world.wind_reading()) {
      flight.tunnel_readings.push_back({time_s, reading->fan_rpm, reading->wind_speed_m_s});
    }
    world.advance();
    if (look && ticks % ticks_between_looks == 0) {
      look(in_seconds(world.now()));
    }
  }
  flight.outages = outages(world);
  flight::end_control_with_outage(flight);
  const sim::World::Events& events = world.events();
  flight.events.liftoff_s = flight.tunnel ? std::nullopt : in_seconds(events.liftoff);
  flight.events.guide_clear_s = in_seconds(events.guide_clear);
  flight.events.burnout_s = in_seconds(events.burnout);
  flight.events.apogee_s = in_seconds(events.apogee);
  flight.events.parachute_s = in_seconds(events.parachute);
  if (scenario.path && !scenario.path->apogee_s) {
    flight.trajectory_end_s = scenario.pad_time_s + scenario.path->samples.back().time_s;
  }
  if (!was_armed) {
    flight.why_not_armed = why_not_armed(world, scenario);
  }
  if (log == Log::kept) {
    keep_log(flight, world, was_armed);
  }
  if (!flight.tunnel && !events.liftoff) {
    flight.notes.emplace_back("The rocket never left the pad: its motor never pushed with more than its weight.");
  }
  // A rocket that never left counts from ignition, or from the refused start command.
  const double zero_s = events.liftoff ? in_seconds(*events.liftoff) : scenario.pad_time_s;
  if (scenario.imposed_roll && events.liftoff) {
    flight.imposed_roll = {.time_s = zero_s + scenario.imposed_roll->time_s,
                           .angle_rad = scenario.imposed_roll->angle_rad,
                           .rate_rad_s = scenario.imposed_roll->rate_rad_s};
  }
  flight::set_time_zero(flight, zero_s);
  flight.loop_margins = loop_margins(scenario, flight);
  for (std::string& sentence : beyond_the_model(scenario, flight)) {
    flight.notes.push_back(std::move(sentence));
  }
  return flight;
}

}  // namespace fantail::fly
