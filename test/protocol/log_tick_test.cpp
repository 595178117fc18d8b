// SPDX-License-Identifier: MIT
#include "protocol/log_tick.hpp"

#include "properties.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {
namespace {

using core::Angle;
using core::Microseconds;

constexpr Microseconds tick_time{5'000'000};

LogTick some_tick() {
  return {.time = tick_time,
          .imu_time = tick_time - Microseconds{120},
          .rate_counts = {1, -2, 32767},
          .specific_force_counts = {-32768, 5, 6},
          .imu_status = DeviceStatus::ok,
          .accelerometer_time = tick_time - Microseconds{65'534},
          .accelerometer_counts = {7, 8, -9},
          .accelerometer_status = DeviceStatus::error,
          .encoder_counts = {0, 1, 8192, 16383},
          .encoder_status = {DeviceStatus::ok, DeviceStatus::error, DeviceStatus::no_reading, DeviceStatus::ok},
          .arm_switch_closed = true,
          .arm_command = false,
          .start_command = true,
          .abort = true,
          .phase = core::Phase::controlling,
          .command_status = core::CommandStatus::controlling,
          .saturated = true,
          .timing_fault = false,
          .command = Angle::from_radians(0.12345678F),
          .canard_commands = {Angle::from_degrees(1.234F), std::nullopt, Angle::from_degrees(-20.0F), Angle{}},
          .duration_before = Microseconds{321},
          .digest = 0xDEADBEEF};
}

TEST(LogTick, ComesBackWithEverythingInIt) {
  const LogTick tick = some_tick();
  SampleTimes packing;
  const PackedTick bytes = pack(tick, packing);
  SampleTimes unpacking;
  const auto back = unpack_tick(tick_time, bytes, unpacking);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->time, tick_time);
  EXPECT_EQ(back->imu_time, tick.imu_time);
  EXPECT_EQ(back->rate_counts, tick.rate_counts);
  EXPECT_EQ(back->specific_force_counts, tick.specific_force_counts);
  EXPECT_EQ(back->imu_status, tick.imu_status);
  EXPECT_EQ(back->accelerometer_time, tick.accelerometer_time);
  EXPECT_EQ(back->accelerometer_counts, tick.accelerometer_counts);
  EXPECT_EQ(back->accelerometer_status, tick.accelerometer_status);
  EXPECT_EQ(back->encoder_counts, tick.encoder_counts);
  EXPECT_EQ(back->encoder_status, tick.encoder_status);
  EXPECT_EQ(back->arm_switch_closed, tick.arm_switch_closed);
  EXPECT_EQ(back->arm_command, tick.arm_command);
  EXPECT_EQ(back->start_command, tick.start_command);
  EXPECT_EQ(back->abort, tick.abort);
  EXPECT_EQ(back->phase, tick.phase);
  EXPECT_EQ(back->command_status, tick.command_status);
  EXPECT_EQ(back->saturated, tick.saturated);
  EXPECT_EQ(back->timing_fault, tick.timing_fault);
  EXPECT_EQ(back->command, tick.command);
  EXPECT_EQ(back->duration_before, tick.duration_before);
  EXPECT_EQ(back->digest, tick.digest);
}

// What a second gyro said lies behind all that a tick of one gyro has.
TEST(LogTick, ASecondGyroComesBackAndChangesNoOtherByte) {
  LogTick tick = some_tick();
  tick.second_gyro = {
      .time = tick_time - Microseconds{400}, .rate_counts = {10, -20, -32768}, .status = DeviceStatus::error};
  SampleTimes packing;
  std::array<std::byte, log_tick_size_with(true, false)> bytes{};
  pack(tick, packing, bytes);
  SampleTimes of_one;
  EXPECT_TRUE(std::ranges::equal(std::span{bytes}.first(log_tick_size), pack(some_tick(), of_one)));
  SampleTimes unpacking;
  const auto back = unpack_tick(tick_time, bytes, unpacking);
  ASSERT_TRUE(back && back->second_gyro);
  EXPECT_EQ(back->second_gyro->time, tick.second_gyro->time);
  EXPECT_EQ(back->second_gyro->rate_counts, tick.second_gyro->rate_counts);
  EXPECT_EQ(back->second_gyro->status, DeviceStatus::error);
  EXPECT_EQ(unpacking.second_gyro, packing.second_gyro);

  bytes.back() = std::byte{3};
  EXPECT_FALSE(unpack_tick(tick_time, bytes, unpacking)) << "there are three states of a device";
}

// 101 325 Pa is 0x0001 8BCD; 4 999 us is 0x1387.
TEST(LogTick, APressureStandsBehindAllElseWithItsAge) {
  LogTick tick = some_tick();
  tick.pressure = {.time = tick_time - Microseconds{4'999}, .pressure_pa = 101'325};
  tick.second_gyro = {.time = tick_time, .rate_counts = {1, 2, 3}, .status = DeviceStatus::ok};
  constexpr std::array<std::uint8_t, pressure_size> expected{0x87, 0x13, 0xCD, 0x8B, 0x01, 0x00};
  for (const bool two_gyros : {false, true}) {
    std::array<std::byte, largest_log_tick> room{};
    const auto bytes = std::span{room}.first(log_tick_size_with(two_gyros, true));
    SampleTimes times;
    pack(tick, times, bytes);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(bytes[bytes.size() - pressure_size + i], std::byte{expected[i]}) << i;
    }
    EXPECT_EQ(without_empty_room(bytes).size(), bytes.size());
    const auto back = unpack_tick(tick_time, bytes, times);
    ASSERT_TRUE(back && back->pressure);
    EXPECT_EQ(back->pressure->time, tick.pressure->time);
    EXPECT_EQ(back->pressure->pressure_pa, 101'325U);
    EXPECT_EQ(back->second_gyro.has_value(), two_gyros);
  }
}

TEST(LogTick, WithoutANewPressureItIsAsLongAsWithoutABarometer) {
  for (const bool two_gyros : {false, true}) {
    std::array<std::byte, largest_log_tick> room{};
    const auto bytes = std::span{room}.first(log_tick_size_with(two_gyros, true));
    SampleTimes times;
    pack(some_tick(), times, bytes);
    const auto written = without_empty_room(bytes);
    EXPECT_EQ(written.size(), log_tick_size_with(two_gyros, false));
    for (const std::span<const std::byte> one : {written, std::span<const std::byte>{bytes}}) {
      const auto back = unpack_tick(tick_time, one, times);
      ASSERT_TRUE(back);
      EXPECT_FALSE(back->pressure);
    }
  }
}

TEST(LogTick, ASecondGyroThatFindsNoRoomIsLeftOutAndNothingBehindTheTickIsWritten) {
  LogTick tick = some_tick();
  tick.second_gyro = {.time = tick_time, .rate_counts = {1, 2, 3}, .status = DeviceStatus::ok};
  std::array<std::byte, largest_log_tick> bytes{};
  SampleTimes packing;
  pack(tick, packing, std::span{bytes}.first(log_tick_size));
  SampleTimes of_one;
  EXPECT_TRUE(std::ranges::equal(std::span{bytes}.first(log_tick_size), pack(some_tick(), of_one)));
  EXPECT_TRUE(
      std::ranges::all_of(std::span{bytes}.subspan(log_tick_size), [](std::byte b) { return b == std::byte{}; }));
}

TEST(LogTick, ACanardsCommandIsKeptToAThousandthOfADegree) {
  SampleTimes times;
  const auto back = unpack_tick(tick_time, pack(some_tick(), times), times);
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->canard_commands[0]->degrees(), 1.234, 1e-5);
  EXPECT_FALSE(back->canard_commands[1]);
  EXPECT_NEAR(back->canard_commands[2]->degrees(), -20.0, 1e-5);
  EXPECT_EQ(back->canard_commands[3], Angle{});
}

TEST(LogTick, ASampleThatGoesOnBeingOldKeepsItsTime) {
  LogTick tick = some_tick();
  tick.imu_time = Microseconds{1'234};
  SampleTimes packing;
  SampleTimes unpacking{.imu = Microseconds{1'234}};  // a checkpoint says so
  for (int k = 0; k < 3; ++k) {
    tick.time += Microseconds{1'000};
    const auto back = unpack_tick(tick.time, pack(tick, packing), unpacking);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->imu_time, Microseconds{1'234});
  }
}

TEST(LogTick, ASampleBecomesOldWithoutAJump) {
  LogTick tick = some_tick();
  const Microseconds measured = tick.imu_time;
  SampleTimes packing;
  SampleTimes unpacking;
  for (int k = 0; k < 200; ++k) {  // through the largest age that has room, 65.5 ms
    tick.time += Microseconds{1'000};
    const auto back = unpack_tick(tick.time, pack(tick, packing), unpacking);
    ASSERT_TRUE(back);
    ASSERT_EQ(back->imu_time, measured) << k;
  }
}

TEST(LogTick, ASampleFromTheFutureIsAnOldOne) {
  LogTick tick = some_tick();
  tick.imu_time = tick_time + Microseconds{1};
  SampleTimes packing;
  const PackedTick bytes = pack(tick, packing);
  SampleTimes unpacking;
  const auto back = unpack_tick(tick_time, bytes, unpacking);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->imu_time, SampleTimes{}.imu) << "that of the tick before";
}

TEST(LogTick, ACommandBeyondItsFieldIsKeptAtTheEndOfIt) {
  LogTick tick = some_tick();
  tick.canard_commands = {Angle::from_degrees(32.767F), Angle::from_degrees(33.0F), Angle::from_degrees(-33.0F), {}};
  SampleTimes packing;
  const PackedTick bytes = pack(tick, packing);
  SampleTimes unpacking;
  const auto back = unpack_tick(tick_time, bytes, unpacking);
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->canard_commands[0]->degrees(), 32.767F, 1e-5F);
  EXPECT_EQ(back->canard_commands[1], back->canard_commands[0]);
  EXPECT_EQ(back->canard_commands[2], -*back->canard_commands[0]);
  EXPECT_FALSE(back->canard_commands[3]);
}

TEST(LogTick, ALongTickIsKeptAsLongAsThereIsRoom) {
  LogTick tick = some_tick();
  tick.duration_before = Microseconds{70'000};
  SampleTimes times;
  EXPECT_EQ(unpack_tick(tick_time, pack(tick, times), times)->duration_before, Microseconds{65'535});
}

TEST(LogTick, APayloadOfAnotherSizeIsRefused) {
  SampleTimes times;
  const PackedTick bytes = pack(some_tick(), times);
  EXPECT_FALSE(unpack_tick(tick_time, std::span{bytes}.first(log_tick_size - 1), times));
  std::vector<std::byte> longer{bytes.begin(), bytes.end()};
  longer.push_back(std::byte{});
  EXPECT_FALSE(unpack_tick(tick_time, longer, times));
}

TEST(LogTick, ValuesThatNoTickHasAreRefused) {
  const auto accepts = [](std::size_t at, std::uint32_t value, auto width) {
    SampleTimes times;
    PackedTick bytes = pack(some_tick(), times);
    put<decltype(width)::value>(bytes, at, value);
    return unpack_tick(tick_time, bytes, times).has_value();
  };
  constexpr std::integral_constant<std::size_t, 2> two;
  constexpr std::integral_constant<std::size_t, 4> four;
  EXPECT_TRUE(accepts(0, 0x0005, two));   // Dormant
  EXPECT_FALSE(accepts(0, 0x0006, two));  // there are six phases
  EXPECT_FALSE(accepts(0, 0x0060, two));  // and three states of a device
  EXPECT_FALSE(accepts(24, 0xC000, two));
  EXPECT_TRUE(accepts(32, 0x3F800000, four));
  EXPECT_FALSE(accepts(32, 0x7FC00000, four));  // a command that is no number
}

RC_GTEST_PROP(LogTick, WhatUnpacksPacksToTheSameBytes, ()) {
  PackedTick bytes{};
  for (std::byte& byte : bytes) {
    byte = std::byte{*rc::gen::arbitrary<std::uint8_t>()};
  }
  SampleTimes unpacking{.imu = Microseconds{1}, .accelerometer = Microseconds{2}};
  SampleTimes packing = unpacking;
  const auto tick = unpack_tick(tick_time, bytes, unpacking);
  RC_PRE(tick.has_value());
  const PackedTick again = pack(*tick, packing);
  put<2>(bytes, 0, get<2>(bytes, 0) & 0x7FFFU);  // the bit that means nothing
  RC_ASSERT(again == bytes);
}

}  // namespace
}  // namespace fantail::protocol
