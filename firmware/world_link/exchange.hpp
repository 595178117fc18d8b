// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "hal/board.hpp"
#include "hal/can_bus.hpp"
#include "hal/flash.hpp"
#include "hal/sim/world_side.hpp"

namespace fantail::world_link {

// What the world and the devices tell each other in one tick: one list for the writer and the reader of each message.

/// Once, before the first tick.
template <typename World, typename Visitor>
void visit_scales(World& world, Visitor& visit) {
  visit(world.imu_scale.rate_rad_s);
  visit(world.imu_scale.specific_force_m_s2);
  visit(world.accelerometer_scale_m_s2);
  visit(world.second_imu_is_fitted);
  visit(world.second_imu_scale.rate_rad_s);
  visit(world.second_imu_scale.specific_force_m_s2);
  visit(world.barometer_is_fitted);
}

template <typename World, typename Visitor>
void visit_second_imu(World& world, Visitor& visit) {
  visit(world.second_imu.time);
  visit(world.second_imu.rate);
  visit(world.second_imu.specific_force);
  visit(world.second_imu.status);
}

template <typename World, typename Visitor>
void visit_barometer(World& world, Visitor& visit) {
  visit(world.barometer.time);
  visit(world.barometer.pressure_pa);
  visit(world.barometer.status);
}

/// What the world put in; a second IMU and a barometer where visit_scales() has said that there is one.
template <typename World, typename Visitor>
void visit_inputs(World& world, Visitor& visit) {
  visit(world.time);
  visit(world.imu.time);
  visit(world.imu.rate);
  visit(world.imu.specific_force);
  visit(world.imu.status);
  if (world.second_imu_is_fitted) {
    visit_second_imu(world, visit);
  }
  if (world.barometer_is_fitted) {
    visit_barometer(world, visit);
  }
  visit(world.accelerometer.time);
  visit(world.accelerometer.specific_force);
  visit(world.accelerometer.status);
  visit(world.encoders.time);
  for (auto& encoder : world.encoders.each) {
    visit(encoder.counts);
    visit(encoder.status);
  }
  visit(world.arm_switch_closed);
  visit(world.abort_contact_closed);
  auto faults = world.board.faults.bits();
  visit(faults);
  if constexpr (!std::is_const_v<World>) {
    world.board.faults = {};
    for (std::size_t i = 0; i < hal::board_faults; ++i) {
      if ((faults >> i & 1U) != 0) {
        world.board.faults.add(static_cast<hal::BoardFault>(i));
      }
    }
  }
  visit(world.board.reset_cause);
  visit(world.board.battery_mv);
  visit(world.board.overruns);
}

/// What the avionics left.
template <typename World, typename Visitor>
void visit_outputs(World& world, Visitor& visit) {
  visit(world.pulses);
  visit(world.shown);
  visit(world.watchdog_fed);
  visit(world.had_tick);
  visit(world.restarted_by);
}

template <typename Frame, typename Visitor>
  requires std::is_same_v<std::remove_const_t<Frame>, hal::CanFrame>
void visit_frame(Frame& frame, Visitor& visit) {
  visit(frame.id);
  visit(frame.extended);
  visit(frame.remote);
  visit(frame.length);
  visit(frame.data);
}

template <typename Geometry, typename Visitor>
void visit_geometry(Geometry& geometry, Visitor& visit) {
  visit(geometry.size);
  visit(geometry.sector_size);
  visit(geometry.page_size);
}

/// How long this tick took the processor, in counts of its clock; what it spent on the link is not in it.
struct TickTimes {
  std::uint32_t tick = 0;      ///< the whole of avionics.tick()
  std::uint32_t step = 0;      ///< of it, the flight law; 0 in an image that does not measure it
  std::uint32_t overruns = 0;  ///< milliseconds that were over before their tick was, since power-up
  friend bool operator==(const TickTimes&, const TickTimes&) = default;
};

template <typename Times, typename Visitor>
void visit_times(Times& times, Visitor& visit) {
  visit(times.tick);
  visit(times.step);
  visit(times.overruns);
}

/// What all of this is known by, the record's signals included: two programs that agree in it understand each other.
[[nodiscard]] std::uint32_t layout();

}  // namespace fantail::world_link
