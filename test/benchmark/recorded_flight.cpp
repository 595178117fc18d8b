// SPDX-License-Identifier: MIT
#include "benchmark/recorded_flight.hpp"

#include <algorithm>

#include "avionics/sensor_scaling.hpp"
#include "input/scenario_file.hpp"
#include "sim/world.hpp"

namespace fantail::benchmark {
namespace {

constexpr core::Microseconds tick_time{1'000};
constexpr std::size_t ticks_per_s = 1'000;

core::Inputs inputs(const hal::sim::WorldSide& hardware, const core::CanardsPlan& canards) {
  const hal::ImuSample& imu = hardware.imu;
  const hal::AccelerometerSample& second = hardware.accelerometer;
  return {.time = hardware.time,
          .gyro = avionics::gyro_sample(imu, hardware.imu_scale),
          .accelerometers = {avionics::accelerometer_sample(imu.time, imu.specific_force, imu.status,
                                                            hardware.imu_scale.specific_force_m_s2),
                             avionics::accelerometer_sample(second.time, second.specific_force, second.status,
                                                            hardware.accelerometer_scale_m_s2)},
          .encoders = avionics::encoder_angles(hardware.encoders, canards),
          .arm_switch_closed = hardware.arm_switch_closed};
}

RecordedFlight fly() {
  RecordedFlight flight{.scenario = input::load_scenario("tasha3_launch2", {}), .ticks = {}};
  sim::World world{flight.scenario};
  core::Phase before = core::Phase::safe;
  while (!world.over()) {
    const core::TickRecord& record = world.tick();
    RecordedTick tick{.hardware = world.hardware(),
                      .inputs = inputs(world.hardware(), flight.scenario.plan.canards),
                      .phase = record.phase,
                      .command = record.command};
    // The command to arm does not pass through the hardware layer; it acted in the tick that armed.
    tick.inputs.arm_command = before == core::Phase::safe && record.phase == core::Phase::armed;
    before = record.phase;
    flight.ticks.push_back(tick);
    world.advance();
  }
  return flight;
}

std::size_t first_of(const RecordedFlight& flight, core::Phase phase) {
  return static_cast<std::size_t>(std::ranges::find(flight.ticks, phase, &RecordedTick::phase) - flight.ticks.begin());
}

}  // namespace

Window RecordedFlight::armed() const {
  // Until well before ignition; the first second is left to whatever arming starts.
  const std::size_t begin = first_of(*this, core::Phase::armed) + ticks_per_s;
  return {.begin = begin, .end = begin + 2 * ticks_per_s};
}

Window RecordedFlight::controlling_with_chirp() const {
  const std::size_t control = first_of(*this, core::Phase::controlling);
  const core::ExcitationPlan& chirp = scenario.plan.excitation;
  return {.begin = control + static_cast<std::size_t>(chirp.begin / tick_time),
          .end = control + static_cast<std::size_t>(chirp.end / tick_time)};
}

const RecordedFlight& recorded_flight() {
  static const RecordedFlight flight = fly();
  return flight;
}

}  // namespace fantail::benchmark
