// SPDX-License-Identifier: MIT
#include "identify/closed_loop/runs.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/chirp.hpp"
#include "core/flight_plan_fields.hpp"
#include "core/roll_reference.hpp"
#include "degree.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "sim/random.hpp"

namespace fantail::identify::closed_loop {

using namespace model;

paper::Loop first_launch() {
  return {
      .plant = {.inertia_kg_m2 = 0.00361,
                .reference_area_m2 = paper::reference_area_m2,
                .damping_m2 = 7.5,
                .torque_m = 10},
      .controller = paper::gains(1, 0.1, 6),
      .reference = paper::step(0, -15, 1.0),
      .excitation = core::default_plan().excitation,
      .disturbance =
          sim::Disturbance{
              {{0, 0.1 * degree}, {1.47, -7.3 * degree}, {2.94, -7 * degree}, {5.97, -7 * degree}, {9, -7.3 * degree}}},
      .speed_m_s = paper::launch_speed(3.47, 0.21),
      .control_from_s = 0.42,
      .servo_lag_s = 0.020,
      .start = {.angle_rad = -0.6 * degree, .rate_rad_s = 51.8 * degree}};
}

NodeTimes first_launch_nodes() { return {0.0, 1.47, 2.94, 5.97, 9.0}; }

paper::Loop second_launch() {
  return {.plant = {.inertia_kg_m2 = 0.00393,
                    .reference_area_m2 = paper::reference_area_m2,
                    .damping_m2 = 23,
                    .torque_m = 9},
          .controller = paper::gains(0.5, 0.05, 9),
          .reference = paper::step(0, -20, 2.0),
          .excitation = core::default_plan().excitation,
          .disturbance = sim::Disturbance{{{0.0, -4.9 * degree}}},
          .speed_m_s = paper::launch_speed(3.99, 0.64),
          .servo_lag_s = 0.020,
          .start = {.rate_rad_s = -20 * degree}};
}

paper::Loop second_launch_with_chirp() {
  paper::Loop loop = second_launch();
  loop.excitation =
      input::read_plan(input::Document::load(input::find_input(input::Shipped::plan, "tasha3_launch2"))).excitation;
  return loop;
}

paper::Loop with_integral(paper::Loop loop) {
  loop.offset = core::default_plan().offset;
  loop.offset.rejection = core::OffsetRejection::integral;
  return loop;
}

paper::Loop with_observer(paper::Loop loop) {
  loop.offset = core::default_plan().offset;
  loop.offset.rejection = core::OffsetRejection::observer;
  loop.roll_model = {.roll_inertia_kg_m2 = static_cast<float>(loop.plant.inertia_kg_m2),
                     .reference_area_m2 = static_cast<float>(loop.plant.reference_area_m2),
                     .damping_m2 = static_cast<float>(loop.plant.damping_m2),
                     .torque_m = static_cast<float>(loop.plant.torque_m),
                     .density_kg_m3 = static_cast<float>(paper::density_kg_m3)};
  return loop;
}

paper::Loop with_schedule(paper::Loop loop) {
  loop.gain_schedule = {.speeds_count = 2, .speeds_m_s = {40.0F, 80.0F}, .factors_count = 2, .factors = {2.0F, 0.75F}};
  return loop;
}

paper::Loop with_noise(paper::Loop loop, std::uint64_t seed) {
  sim::Random random{seed, 0};
  loop.measured_off.clear();
  for (int tick = 0; tick <= 4000; ++tick) {
    loop.measured_off.push_back(
        {.angle_rad = 0.3 * degree * random.gaussian(), .rate_rad_s = 1.0 * degree * random.gaussian()});
  }
  return loop;
}

Record closed_loop_record(const paper::Loop& loop, double to_s, int every_ms) {
  Record record = paper::flown_record(loop, 0.0, to_s, every_ms);
  core::Chirp chirp{loop.excitation};
  for (const double time_s : record.time_s) {
    const core::Microseconds since{std::lround((time_s - loop.control_from_s) * 1e6)};
    const bool in_control = since.count() >= 0;
    record.in_control.push_back(in_control);
    record.reference_rad.push_back(
        in_control ? static_cast<double>(core::roll_reference(loop.reference, since).radians()) : 0.0);
    record.excitation_rad.push_back(in_control ? static_cast<double>(chirp.update(since).radians()) : 0.0);
  }
  return record;
}

Control controller_of(const paper::Loop& loop) {
  return {.controller = loop.controller,
          .gain_schedule = loop.gain_schedule,
          .offset_rejection = loop.offset.rejection,
          .servo_lag_s = loop.servo_lag_s.value_or(0.0)};
}

RollModel truth(const paper::Loop& loop, const NodeTimes& node_time_s) {
  RollModel model{.alpha_m2 = loop.plant.damping_m2,
                  .beta_m = loop.plant.torque_m,
                  .node_time_s = node_time_s,
                  .node_rad = {},
                  .initial = {{.angle_rad = loop.start.angle_rad, .rate_rad_s = loop.start.rate_rad_s}}};
  for (const double time_s : node_time_s) {
    model.node_rad.push_back(loop.disturbance.at(time_s));
  }
  return model;
}

void expect_same(const RollModel& found, const RollModel& truth, double times) {
  EXPECT_NEAR(found.alpha_m2, truth.alpha_m2, 0.01 * times);
  EXPECT_NEAR(found.beta_m, truth.beta_m, 0.001 * times);
  ASSERT_EQ(found.node_rad.size(), truth.node_rad.size());
  for (std::size_t k = 0; k < found.node_rad.size(); ++k) {
    EXPECT_NEAR(found.node_rad[k] / degree, truth.node_rad[k] / degree, 0.01 * times) << "node " << k;
  }
}

}  // namespace fantail::identify::closed_loop
