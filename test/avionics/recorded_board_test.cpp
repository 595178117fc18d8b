// SPDX-License-Identifier: MIT

#include "avionics/log_tick_of.hpp"
#include "avionics/sensor_scaling.hpp"
#include "core/flight_plan_fields.hpp"
#include "protocol/tick_digest.hpp"
#include "recorder_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

// What a record says of the board beside the flight.

using core::Phase;
using protocol::LogEventKind;

struct RecordedBoard : testing::Test {
  hal::sim::Flash flash{one_mib};
  RecorderRig rig{flash};
  [[nodiscard]] std::span<const std::byte> log() { return region_of(flash); }
};

TEST_F(RecordedBoard, TellsHowManyCyclesALongerTickTookThanAllOfTheFlightBeforeIt) {
  rig.run(Phase::armed, 1000);
  rig.board.cycles = 99'000;  // on the pad
  rig.run(Phase::launched, 100);
  for (const std::uint32_t cycles : {30'000U, 20'000U, 50'000U}) {
    rig.board.cycles = cycles;
    rig.run(Phase::launched, 100);
  }
  rig.settle(Phase::armed);
  std::vector<std::uint32_t> told;
  for (const protocol::LogEvent& event : events_in(log())) {
    if (event.kind == LogEventKind::longest_tick) {
      told.push_back(event.number);
    }
  }
  EXPECT_EQ(told, (std::vector<std::uint32_t>{30'000, 50'000}));
}

TEST_F(RecordedBoard, TellsEveryFaultOfTheBoardThatComesOrGoes) {
  rig.run(Phase::armed, 1000);
  rig.run(Phase::launched, 100);
  const core::Microseconds came = rig.time + tick;
  rig.faults.add(hal::BoardFault::supply_low);
  rig.run(Phase::launched, 1000);
  rig.faults.add(hal::BoardFault::imu_silent);
  rig.run(Phase::launched, 100);
  rig.faults = {};
  rig.run(Phase::launched, 100);
  rig.settle(Phase::armed);
  std::vector<std::uint32_t> told;
  std::vector<core::Microseconds> times;
  for (const protocol::LogEvent& event : events_in(log())) {
    if (event.kind == LogEventKind::board_faults) {
      told.push_back(event.number);
      times.push_back(event.time);
    }
  }
  constexpr std::uint32_t low = 1U << static_cast<unsigned>(hal::BoardFault::supply_low);
  constexpr std::uint32_t silent = 1U << static_cast<unsigned>(hal::BoardFault::imu_silent);
  EXPECT_EQ(told, (std::vector<std::uint32_t>{low, low | silent, 0}));
  EXPECT_EQ(times.at(0), came);
}

TEST_F(RecordedBoard, AFaultThatComesAndGoesEveryTickIsToldTenTimesASecondAtMost) {
  rig.run(Phase::armed, 1000);
  for (int i = 0; i < 2001; ++i) {
    rig.faults = {};
    if (i % 2 == 0) {
      rig.faults.add(hal::BoardFault::imu_silent);
    }
    rig.tick(Phase::launched);
  }
  rig.settle(Phase::armed);
  const auto events = events_in(log());
  const auto told = std::ranges::count(events, LogEventKind::board_faults, &protocol::LogEvent::kind);
  EXPECT_GE(told, 10);
  EXPECT_LE(told, 21);
  EXPECT_EQ(std::ranges::count(events, LogEventKind::records_dropped, &protocol::LogEvent::kind), 0);
}

using core::Angle;
using core::Microseconds;
using hal::Status;

constexpr SampleScales scales{.imu = {.rate_rad_s = 0.001F, .specific_force_m_s2 = 0.005F},
                              .second_rate_rad_s = 0.002F,
                              .accelerometer_m_s2 = 0.05F};

RawSamples some_samples() {
  return {
      .imu = {.time = Microseconds{990},
              .rate = {1, -2, 32767},
              .specific_force = {-32768, 5, 6},
              .status = Status::ok},
      .accelerometer = {.time = Microseconds{800}, .specific_force = {7, -8, 9}, .status = Status::error},
      .encoders = {.time = Microseconds{1000},
                   .each = {{{16383, Status::ok}, {0, Status::error}, {77, Status::no_reading}, {8192, Status::ok}}}}};
}

core::Inputs inputs_from(const RawSamples& raw, const core::CanardsPlan& canards) {
  return {.time = Microseconds{1000},
          .gyro = gyro_sample(raw.imu, scales.imu),
          .accelerometers = {accelerometer_sample(raw.imu.time, raw.imu.specific_force, raw.imu.status,
                                                  scales.imu.specific_force_m_s2),
                             accelerometer_sample(raw.accelerometer.time, raw.accelerometer.specific_force,
                                                  raw.accelerometer.status, scales.accelerometer_m_s2)},
          .encoders = encoder_angles(raw.encoders, canards),
          .arm_switch_closed = true,
          .arm_command = false,
          .start_command = true,
          .abort = true};
}

void expect_equal(const core::Vector3& a, const core::Vector3& b) {
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.z, b.z);
}

void expect_equal(const core::Inputs& a, const core::Inputs& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.gyro.time, b.gyro.time);
  expect_equal(a.gyro.rate_rad_s, b.gyro.rate_rad_s);
  EXPECT_EQ(a.gyro.quality, b.gyro.quality);
  for (std::size_t i = 0; i < a.accelerometers.size(); ++i) {
    EXPECT_EQ(a.accelerometers[i].time, b.accelerometers[i].time);
    expect_equal(a.accelerometers[i].specific_force_m_s2, b.accelerometers[i].specific_force_m_s2);
    EXPECT_EQ(a.accelerometers[i].quality, b.accelerometers[i].quality);
  }
  EXPECT_EQ(a.encoders, b.encoders);
  EXPECT_EQ(a.arm_switch_closed, b.arm_switch_closed);
  EXPECT_EQ(a.arm_command, b.arm_command);
  EXPECT_EQ(a.start_command, b.start_command);
  EXPECT_EQ(a.abort, b.abort);
}

TEST(LogTickOf, TheInputsThatComeOutAreThoseThatWentIn) {
  const core::CanardsPlan canards = core::default_plan().canards;
  const core::Inputs inputs = inputs_from(some_samples(), canards);
  const protocol::LogTick tick = log_tick_of({}, some_samples(), inputs, {});
  expect_equal(inputs_of(tick, scales, canards), inputs);

  protocol::SampleTimes writing;
  protocol::SampleTimes reading;
  const auto unpacked = protocol::unpack_tick(tick.time, protocol::pack(tick, writing), reading);
  ASSERT_TRUE(unpacked.has_value());
  expect_equal(inputs_of(*unpacked, scales, canards), inputs);
}

TEST(LogTickOf, SoDoesTheSecondGyroWhereThereIsOne) {
  const core::CanardsPlan canards = core::default_plan().canards;
  RawSamples raw = some_samples();
  EXPECT_FALSE(inputs_of(log_tick_of({}, raw, inputs_from(raw, canards), {}), scales, canards).second_gyro);
  raw.second_imu = hal::ImuSample{.time = Microseconds{995}, .rate = {100, -200, 300}, .status = Status::ok};
  const protocol::LogTick tick = log_tick_of({}, raw, inputs_from(raw, canards), {});
  protocol::SampleTimes writing;
  protocol::SampleTimes reading;
  std::array<std::byte, protocol::largest_log_tick> bytes{};
  protocol::pack(tick, writing, bytes);
  const auto unpacked = protocol::unpack_tick(tick.time, bytes, reading);
  ASSERT_TRUE(unpacked.has_value());
  const auto second = inputs_of(*unpacked, scales, canards).second_gyro;
  ASSERT_TRUE(second.has_value());
  EXPECT_EQ(second->time, Microseconds{995});
  EXPECT_EQ(second->quality, core::SampleQuality::valid);
  expect_equal(second->rate_rad_s, {0.2F, -0.4F, 0.6F});
}

TEST(LogTickOf, ACountThatOneTurnDoesNotHaveIsNoReadingInTheReplayEither) {
  const core::CanardsPlan canards = core::default_plan().canards;
  RawSamples raw = some_samples();
  raw.encoders.each[0] = {.counts = hal::encoder_counts_per_turn, .status = Status::ok};
  raw.encoders.each[2] = {.counts = 65535, .status = Status::no_reading};
  const protocol::LogTick tick = log_tick_of({}, raw, inputs_from(raw, canards), {});
  EXPECT_EQ(tick.encoder_status[0], protocol::DeviceStatus::error);
  EXPECT_EQ(tick.encoder_status[2], protocol::DeviceStatus::no_reading);
  EXPECT_FALSE(inputs_of(tick, scales, canards).encoders[0].has_value());
}

TEST(LogTickOf, WhatCameOutOfTheLawIsKeptWithItsDigest) {
  core::TickRecord record;
  record.time = Microseconds{1000};
  record.phase = core::Phase::controlling;
  record.command_status = core::CommandStatus::controlling;
  record.saturated = true;
  record.command = Angle::from_degrees(6.0F);
  record.canards[1] = {.angle = Angle::from_degrees(-3.0F), .pulse_us = 1500.0F, .driven = true};
  const RawSamples raw = some_samples();
  const protocol::LogTick tick =
      log_tick_of(record, raw, inputs_from(raw, core::default_plan().canards), Microseconds{123});
  EXPECT_EQ(tick.time, Microseconds{1000});
  EXPECT_EQ(tick.phase, core::Phase::controlling);
  EXPECT_EQ(tick.command_status, core::CommandStatus::controlling);
  EXPECT_TRUE(tick.saturated);
  EXPECT_FALSE(tick.timing_fault);
  EXPECT_EQ(tick.command, Angle::from_degrees(6.0F));
  EXPECT_EQ(tick.canard_commands[1], Angle::from_degrees(-3.0F));
  EXPECT_FALSE(tick.canard_commands[0].has_value()) << "it was not driven";
  EXPECT_EQ(tick.duration_before, Microseconds{123});
  EXPECT_EQ(tick.digest, protocol::tick_digest(record));
}

}  // namespace

}  // namespace fantail::avionics
