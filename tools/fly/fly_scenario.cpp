// SPDX-License-Identifier: MIT
#include "fly/fly_scenario.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <fmt/core.h>

#include "fly/burn_watch.hpp"
#include "fly/describe.hpp"
#include "fly/loop_margins.hpp"
#include "fly/model_limits.hpp"
#include "fly/to_ground.hpp"
#include "replies/sentence.hpp"
#include "sim/lean_board.hpp"
#include "sim/nearest_tick.hpp"
#include "sim/units.hpp"
#include "sim/world.hpp"

namespace fantail::fly {
namespace {

double in_seconds(core::Microseconds time) { return 1e-6 * static_cast<double>(time.count()); }

std::optional<double> in_seconds(const std::optional<core::Microseconds>& time) {
  return time ? std::optional{in_seconds(*time)} : std::nullopt;
}

/// A trajectory without a tilt of its own, which has that of the guide all along.
bool cannot_tilt(const sim::Scenario& scenario) {
  return scenario.path && std::ranges::all_of(scenario.path->samples, [&](const auto& sample) {
           return sample.tilt_rad == scenario.path->samples.front().tilt_rad;
         });
}

flight::Truth truth_of(const sim::World& world, bool tilts) {
  const sim::Truth truth = world.truth();
  const std::optional<sim::Path> path = world.path();
  return {.roll_angle_rad = truth.roll_angle_rad,
          .roll_rate_rad_s = truth.roll_rate_rad_s,
          .canard_rad = truth.canard_rad,
          .height_m = truth.height_m,
          .speed_m_s = truth.speed_m_s,
          .disturbance_rad = truth.disturbance_rad,
          .geometric_roll_rad = truth.geometric_roll_rad,
          .tilt_from_guide_rad = path && tilts ? std::optional{path->tilt_from_guide_rad} : std::nullopt,
          .shafts_rad = world.shafts_rad()};
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

/// Beside those that the ticks tell.
void add_outages(flight::Flight& flight, const sim::World& world) {
  std::vector<flight::Outage>& all = flight.outages;
  for (const sim::World::Gap& gap : world.gaps()) {
    all.push_back({.from_s = in_seconds(gap.from - sim::tick_time),
                   .to_s = in_seconds(gap.to),
                   .cause = std::string{gap.cause ? hal::name(*gap.cause) : ""},
                   .resumed = gap.resumed});
  }
  std::ranges::stable_sort(all, {}, &flight::Outage::from_s);
  const bool ends_with_one = !all.empty() && !all.back().to_s;
  if (world.is_down() && !ends_with_one && flight.last_tick_s) {
    all.push_back({.from_s = *flight.last_tick_s, .to_s = {}, .cause = {}, .resumed = false});
  }
}

/// "imu_silent, flash_failed", of a bit for each.
std::string named(std::uint32_t faults) {
  std::string names;
  for (std::size_t i = 0; i < hal::board_faults; ++i) {
    if ((faults >> i & 1U) != 0) {
      names += (names.empty() ? "" : ", ") + std::string{hal::name(static_cast<hal::BoardFault>(i))};
    }
  }
  return names;
}

std::string why_not_armed(const sim::World& world, const sim::Scenario& scenario) {
  constexpr double self_test_s = 7.5;
  const auto refusal = world.refusal_to_arm();
  const double left_s = scenario.pad_time_s - scenario.arm_time_s;
  // A self-test that the launch interrupts fails because the rocket does not stand still.
  if (!refusal || (left_s < self_test_s && refusal->failure == protocol::SelfTestFailure::moved)) {
    return fmt::format(
        "its self-test takes about seven seconds, and {:g} s after its start {} (timing.arm_time_s, timing.pad_time_s)",
        left_s,
        scenario.surroundings != sim::Surroundings::flight ? "the start command came" : "the motor was ignited");
  }
  const bool is_of_board =
      refusal->refusal == protocol::ArmRefusal::board_fault ||
      (refusal->refusal == protocol::ArmRefusal::none && refusal->failure == protocol::SelfTestFailure::board_fault);
  if (const std::string faults = named(world.faults_told_to_crew()); is_of_board && !faults.empty()) {
    return "the avionics refused to be armed: the board has a fault: " + faults;
  }
  return "the avionics refused to be armed: " + (refusal->refusal != protocol::ArmRefusal::none
                                                     ? replies::sentence(refusal->refusal)
                                                     : replies::sentence(refusal->failure, refusal->canard));
}

void keep_log(flight::Flight& flight, const sim::World& world, bool was_armed) {
  const std::span<const std::byte> recorded = world.recorded();
  flight.log.assign(recorded.begin(), recorded.end());
  if (flight.log.empty()) {
    flight.notes.push_back(fmt::format("The avionics recorded nothing, so there is no flight.ftl: {}.",
                                       !was_armed      ? "they were never armed"
                                       : flight.tunnel ? "they were never started"
                                                       : "they detected no launch"));
  } else if (world.record_is_full()) {
    flight.notes.emplace_back("flight.ftl ends before the run does: the flash memory of the avionics was full.");
  }
}

}  // namespace

std::optional<double> expected_length_s(const sim::Scenario& scenario) {
  if (scenario.surroundings == sim::Surroundings::flight) {
    return std::nullopt;
  }
  return scenario.pad_time_s + in_seconds(scenario.plan.run.control_time) + scenario.time_after_end_s;
}

namespace {

void note_events(flight::Flight& flight, const sim::World::Events& events) {
  flight.events.liftoff_s = flight.tunnel ? std::nullopt : in_seconds(events.liftoff);
  flight.events.guide_clear_s = in_seconds(events.guide_clear);
  flight.events.burnout_s = in_seconds(events.burnout);
  flight.events.apogee_s = in_seconds(events.apogee);
  flight.events.parachute_s = in_seconds(events.parachute);
}

/// What is looked at in every row.
struct Watches {
  SpeedsUnderControl speeds;
  ModelLimits limits;
  const TakeRow& take;

  void add(const flight::Row& row, const flight::Flight& so_far) {
    speeds.add(row);
    limits.add(row, so_far);
    if (take) {
      take(row, so_far);
    }
  }
};

struct Hooks {
  const Look& look;
  const Observe& observe;
  const TakeRow& take;  ///< empty: the flight keeps its rows
};

flight::Flight fly(const sim::Scenario& scenario, const Hooks& hooks, Log log, const sim::MakeFlightComputer& make) {
  constexpr std::int64_t ticks_between_looks = 1024;
  constexpr std::int64_t ticks_between_points = 10;
  flight::Flight flight = describe(scenario);
  if (!hooks.take) {
    flight.side_moment_m3 = side_moment_m3(scenario.vehicle);
  }
  // A launch is judged by every tick. In the tunnel a run of a quarter of an hour would fill the memory.
  const std::int64_t ticks_per_line = std::llround(scenario.log_period_s * 1e3);
  const std::int64_t ticks_per_row = flight.tunnel ? ticks_per_line : 1;
  flight.rows_per_line = static_cast<std::size_t>(ticks_per_line / ticks_per_row);
  if (const auto length_s = expected_length_s(scenario); length_s && !hooks.take) {
    flight.rows.reserve(static_cast<std::size_t>(*length_s * 1e3) / static_cast<std::size_t>(ticks_per_row) + 1);
  }
  sim::World world{scenario, log == Log::kept ? sim::World::large_flash : sim::World::small_flash, make};
  const bool is_held = scenario.surroundings == sim::Surroundings::gimbal || scenario.pin;
  const bool tilts = !cannot_tilt(scenario);
  bool was_armed = false;
  Watches watches{.speeds = {}, .limits = ModelLimits{scenario}, .take = hooks.take};
  BurnWatch burn{scenario};
  for (std::int64_t ticks = 0; !world.over(); ++ticks) {
    const core::TickRecord& record = world.tick();
    burn.look(world, in_seconds(world.now()));
    if (world.is_down()) {
      world.advance();
      continue;
    }
    if (hooks.observe) {
      hooks.observe(record);
    }
    was_armed = was_armed || record.phase != core::Phase::safe;
    const double time_s = in_seconds(world.now());
    note_events(flight, world.events());
    flight::note_tick(flight, record, time_s);
    if (ticks % ticks_per_row == 0) {
      flight::Row row = flight::row(record, time_s);
      row.truth = truth_of(world, tilts);
      watches.add(row, flight);
      if (!hooks.take) {
        flight.rows.push_back(row);
      }
    }
    if (ticks % ticks_between_points == 0) {
      if (const auto path = world.path()) {
        flight.path.push_back(path_point(*path, time_s));
      }
      if (is_held) {
        flight.turning.push_back(turn_point(world, record, time_s));
      }
    }
    if (const auto reading = world.wind_reading()) {
      flight.tunnel_readings.push_back({time_s, reading->fan_rpm, reading->wind_speed_m_s});
    }
    world.advance();
    if (hooks.look && ticks % ticks_between_looks == 0) {
      hooks.look(in_seconds(world.now()));
    }
  }
  add_outages(flight, world);
  flight::end_control_with_outage(flight);
  const sim::World::Events& events = world.events();
  note_events(flight, events);
  flight.before_burnout = burn.found();
  if (scenario.path && !scenario.path->apogee_s) {
    flight.trajectory_end_s = scenario.pad_time_s + scenario.path->samples.back().time_s;
  }
  if (!was_armed) {
    flight.why_not_armed = why_not_armed(world, scenario);
  }
  if (log == Log::kept) {
    keep_log(flight, world, was_armed);
  }
  if (!hooks.take) {
    add_descent(flight, world, scenario);
  }
  if (!flight.tunnel && !events.liftoff) {
    flight.notes.emplace_back("The rocket never left the pad: its motor never pushed with more than its weight.");
  }
  if (std::string never = never_happened(scenario, in_seconds(world.now()) - scenario.pad_time_s); !never.empty()) {
    flight.notes.push_back(std::move(never));
  }
  // A rocket that never left counts from ignition, or from the refused start command.
  const double zero_s = events.liftoff ? in_seconds(*events.liftoff) : scenario.pad_time_s;
  if (scenario.imposed_roll && events.liftoff) {
    flight.imposed_roll = {.time_s = zero_s + scenario.imposed_roll->time_s,
                           .angle_rad = scenario.imposed_roll->angle_rad,
                           .rate_rad_s = scenario.imposed_roll->rate_rad_s};
  }
  flight::set_time_zero(flight, zero_s);
  flight.loop_margins = loop_margins(scenario, watches.speeds.take());
  flight.extremes = flight.tunnel ? flight::Extremes{} : watches.limits.extremes(flight);
  for (std::string& sentence : watches.limits.gone_beyond(flight)) {
    flight.notes.push_back(std::move(sentence));
  }
  return flight;
}

}  // namespace

flight::Flight fly_scenario(const sim::Scenario& scenario, const Look& look, const Observe& observe, Log log,
                            const sim::MakeFlightComputer& make) {
  return fly(scenario, {.look = look, .observe = observe, .take = {}}, log, make);
}

flight::Flight fly_without_rows(const sim::Scenario& scenario, const TakeRow& take) {
  return fly(scenario, {.look = {}, .observe = {}, .take = take}, Log::dropped, sim::unrecorded_board(scenario));
}

std::vector<double> speeds_under_control_m_s(const sim::Scenario& scenario) {
  SpeedsUnderControl speeds;
  (void)fly_without_rows(scenario, [&](const flight::Row& row, const flight::Flight&) { speeds.add(row); });
  return speeds.take();
}

}  // namespace fantail::fly
