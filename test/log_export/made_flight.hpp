// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "core/flight_plan_fields.hpp"
#include "flight_log/flight_log.hpp"
#include "flight_log/regenerate.hpp"
#include "log_export/replayed_flight.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::log_export {

/// A log and its replay, made by hand: 1 kHz from 10 s of the board's clock on, which is -0.1 s; detected at 0 s,
/// control from 0.2 s on; 1000 ticks in all, of which those from 500 to 549 are missing and those from 550 to 559 could
/// not be replayed. Tick i has a roll angle of i millidegrees, canard k is told i / 100 + k degrees and stands at half
/// of that; canard 4 is not driven and has no encoder.
struct MadeFlight {
  static constexpr int ticks = 1000;
  static constexpr std::int64_t begin_us = 10'000'000;

  flight_log::Flight flight;
  flight_log::Regeneration regeneration;
  flight::Flight report;

  MadeFlight() {
    make_header();
    for (int i = 0; i < ticks; ++i) {
      if (i < 500 || i >= 550) {
        add(i);
      }
    }
    flight.gaps = {{.first_missing = 500, .count = 50, .before = time(499), .after = time(550)}};
    flight.events = {{.time = time(100),
                      .kind = protocol::LogEventKind::phase,
                      .value = static_cast<std::uint8_t>(core::Phase::launched),
                      .detail = static_cast<std::uint8_t>(core::PhaseReason::launch_detected)},
                     {.time = time(700),
                      .kind = protocol::LogEventKind::canard_verdict,
                      .value = static_cast<std::uint8_t>(core::CanardVerdict::stalled),
                      .index = 2}};
    for (const int i : {50, 150, 950}) {
      flight.health.push_back({.time = time(i),
                               .gyro = core::SensorState::fresh,
                               .accelerometer = core::SensorState::coasting,
                               .longest_tick_us = static_cast<std::uint16_t>(i)});
    }
  }

  [[nodiscard]] ReplayedFlight source(Window window = {}) const { return {flight, regeneration, report, window}; }
  [[nodiscard]] static core::Microseconds time(int tick) { return core::Microseconds{begin_us + 1000 * tick}; }
  [[nodiscard]] static float command_deg(int tick, int canard) {
    return static_cast<float>(tick) / 100.0F + static_cast<float>(canard);
  }

 private:
  void make_header() {
    flight.has_header = true;
    flight.format_version = 1;
    flight.flight = 4096;
    flight.power_up = 7;
    flight.firmware_version = "9.8.7";
    flight.git_hash = "0123abc";
    flight.vehicle = "paper dart";
    flight.sensors = "made by hand";
    flight.plan = core::default_plan();
    flight.plan_block.resize(protocol::largest_plan_block);
    flight.plan_block.resize(protocol::write_plan_block(
        *flight.plan, std::span<std::byte, protocol::largest_plan_block>{flight.plan_block}));
  }

  void add(int i) {
    const core::Phase phase = i < 100 ? core::Phase::armed : i < 300 ? core::Phase::launched : core::Phase::controlling;
    flight_log::LoggedTick logged;
    logged.sequence = static_cast<std::uint32_t>(i);
    protocol::LogTick& tick = logged.tick;
    tick.time = time(i);
    tick.imu_time = tick.time - core::Microseconds{250};
    tick.rate_counts = {static_cast<std::int16_t>(i), static_cast<std::int16_t>(-i), 5};
    tick.imu_status = protocol::DeviceStatus::ok;
    tick.accelerometer_time = tick.time;
    tick.encoder_counts = {static_cast<std::uint16_t>(i), 16383, 0, 0};
    tick.encoder_status = {protocol::DeviceStatus::ok, protocol::DeviceStatus::ok, protocol::DeviceStatus::ok,
                           protocol::DeviceStatus::no_reading};
    tick.arm_switch_closed = true;
    tick.phase = phase;
    tick.command_status =
        phase == core::Phase::controlling ? core::CommandStatus::controlling : core::CommandStatus::outside_control;
    tick.command = core::Angle::from_degrees(static_cast<float>(i) / 200.0F);
    tick.digest = 0xFFFF0000U + static_cast<std::uint32_t>(i);

    core::TickRecord record;
    record.time = tick.time;
    record.phase = phase;
    record.command_status = tick.command_status;
    record.command = tick.command;
    record.motion.roll_angle = core::Angle::from_degrees(static_cast<float>(i) / 1000.0F);
    record.motion.roll_rate_rad_s = core::Angle::from_degrees(1.0F).radians();
    record.motion.specific_force_m_s2 = {30.0F, 1.0F, 2.0F};
    record.motion.speed_m_s = static_cast<float>(i) / 8.0F;
    for (int k = 0; k < 3; ++k) {
      const auto c = static_cast<std::size_t>(k);
      tick.canard_commands[c] = core::Angle::from_degrees(command_deg(i, k + 1));
      record.canards[c] = {.angle = *tick.canard_commands[c], .pulse_us = 1500.0F, .driven = true, .limited = false};
      record.encoders[c] = 0.5F * *tick.canard_commands[c];
    }
    record.canard_angle = core::Angle::from_degrees(command_deg(i, 2) / 2.0F);
    flight.ticks.push_back(logged);
    if (i >= 550 && i < 560) {
      regeneration.records.emplace_back();
      ++regeneration.unreachable;
    } else {
      regeneration.records.emplace_back(record);
      ++regeneration.compared;
      flight::add_tick(report, record, static_cast<double>(i - 100) / 1000.0, std::nullopt);
    }
  }
};

}  // namespace fantail::log_export
