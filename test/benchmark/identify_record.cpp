// SPDX-License-Identifier: MIT
#include "benchmark/identify_record.hpp"

#include <cmath>
#include <cstddef>

#include "identify/model/roll_model.hpp"
#include "input/scenario_file.hpp"
#include "sim/world.hpp"

namespace fantail::benchmark {
namespace {

constexpr std::size_t ticks_per_s = 1'000;
constexpr std::size_t seconds = 9;

sim::Scenario scenario() {
  sim::Scenario launch = input::load_scenario("tasha3_launch2", {});
  constexpr double degree = 0.017453292519943295;
  // Corners where the nodes will stand: control starts 0.65 s after lift-off.
  launch.disturbance = {{.time_s = 0.65, .angle_rad = -3.0 * degree},
                        {.time_s = 2.9, .angle_rad = -6.5 * degree},
                        {.time_s = 5.15, .angle_rad = -5.0 * degree},
                        {.time_s = 7.4, .angle_rad = -4.0 * degree},
                        {.time_s = 9.65, .angle_rad = -5.0 * degree}};
  return launch;
}

void add_sample(identify::model::Record& record, const core::TickRecord& tick, double time_s,
                const sim::Atmosphere& air) {
  record.time_s.push_back(time_s);
  record.roll_angle_rad.push_back(static_cast<double>(tick.motion.roll_angle.radians()));
  record.roll_rate_rad_s.push_back(static_cast<double>(tick.motion.roll_rate_rad_s));
  record.canard_rad.push_back(static_cast<double>(tick.canard_angle.value_or(tick.command).radians()));
  record.speed_m_s.push_back(static_cast<double>(tick.motion.speed_m_s));
  record.density_kg_m3.push_back(air.density_kg_m3(static_cast<double>(tick.motion.height_m)));
  record.reference_rad.push_back(static_cast<double>(tick.reference.radians()));
  record.excitation_rad.push_back(static_cast<double>(tick.excitation.radians()));
  record.in_control.push_back(tick.phase == core::Phase::controlling);
}

// Every so many values of an axis, so that `through` is one of them.
identify::model::Axis thinned(const identify::model::Axis& axis, double through, double every) {
  const double step = every * axis.step;
  return {.first = through - step * std::floor((through - axis.first) / step + 1e-9), .last = axis.last, .step = step};
}

IdentifyTask fly(SampleRate rate) {
  const sim::Scenario launch = scenario();
  IdentifyTask task{.record = {},
                    .airframe = {.inertia_kg_m2 = launch.vehicle.roll_plant.inertia_kg_m2,
                                 .reference_area_m2 = launch.vehicle.roll_plant.reference_area_m2},
                    .loop = {.controller = launch.plan.controller, .servo_lag_s = 0.02},
                    .node_time_s = {},
                    .expected = {},
                    .some_points = {}};
  const std::size_t ticks_per_sample = ticks_per_s / static_cast<std::size_t>(rate);
  sim::World world{launch};
  for (std::size_t ticks = 0; ticks <= seconds * ticks_per_s && !world.over(); world.advance()) {
    const core::TickRecord& tick = world.tick();
    if (tick.phase != core::Phase::controlling) {
      continue;
    }
    if (ticks % ticks_per_sample == 0) {
      add_sample(task.record, tick, static_cast<double>(ticks) / static_cast<double>(ticks_per_s), launch.atmosphere);
    }
    ++ticks;
  }
  task.record.window = "9 s from control start";
  task.node_time_s = identify::model::even_nodes(task.record, 4);
  const identify::model::Grid whole;
  task.expected = identify::model::search_open_loop_grid(task.record, task.airframe, task.node_time_s,
                                                         identify::model::Start::measured, whole);
  task.some_points = {.alpha_m2 = thinned(whole.alpha_m2, task.expected.model.alpha_m2, 6),
                      .beta_m = thinned(whole.beta_m, task.expected.model.beta_m, 4)};
  return task;
}

}  // namespace

const IdentifyTask& identify_task(SampleRate rate) {
  static const IdentifyTask slow = fly(SampleRate::hz_100);
  static const IdentifyTask fast = fly(SampleRate::hz_1000);
  return rate == SampleRate::hz_100 ? slow : fast;
}

}  // namespace fantail::benchmark
