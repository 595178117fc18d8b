// SPDX-License-Identifier: MIT
// Where the values of a tick lie, byte by byte, as log_schema.cpp tells readers of other versions.

#include "protocol/little_endian.hpp"
#include "protocol/log_tick.hpp"
#include "test.hpp"

namespace fantail::protocol {
namespace {

using core::Angle;
using core::Microseconds;

constexpr Microseconds time_of_tick{9'000'000};
constexpr std::byte behind{0x5A};

LogTick tick_of_known_bytes() {
  return {.time = time_of_tick,
          .imu_time = time_of_tick - Microseconds{0x0102},
          .rate_counts = {0x0304, -2, 0x0506},
          .specific_force_counts = {0x0708, 0x090A, 0x0B0C},
          .imu_status = DeviceStatus::error,
          .second_gyro = LogSecondGyro{.time = time_of_tick - Microseconds{0x2728},
                                       .rate_counts = {0x292A, 0x2B2C, 0x2D2E},
                                       .status = DeviceStatus::error},
          .accelerometer_time = time_of_tick - Microseconds{0x0D0E},
          .accelerometer_counts = {0x0F10, 0x1112, 0x1314},
          .accelerometer_status = DeviceStatus::no_reading,
          .encoder_counts = {0x1516, 0x1718, 0x191A, 0x3FFF},
          .encoder_status = {DeviceStatus::error, DeviceStatus::ok, DeviceStatus::no_reading, DeviceStatus::ok},
          .arm_switch_closed = true,
          .phase = core::Phase::controlling,
          .command_status = core::CommandStatus::gyro_lost,
          .command = Angle::from_radians(1.0F),
          .canard_commands = {Angle::from_degrees(1.234F), Angle::from_degrees(-20.0F), std::nullopt, Angle{}},
          .duration_before = Microseconds{0x2122},
          .digest = 0x23242526};
}

// 1234 and -20000 millidegrees are 0x04D2 and 0xB1E0; the third canard is not driven.
TEST(LogTickLayout, EveryByteIsWhereTheSchemaSays) {
  constexpr unsigned flags = 3U | 2U << 3U | 1U << 5U | 2U << 7U | 1U << 9U;
  constexpr std::array<std::uint8_t, 59> expected{
      flags & 0xFFU, flags >> 8U,                                      // phase and all that has a few bits
      0x02,          0x01,        0x04, 0x03, 0xFE, 0xFF, 0x06, 0x05,  // IMU: age, rates
      0x08,          0x07,        0x0A, 0x09, 0x0C, 0x0B,              // and specific force
      0x0E,          0x0D,        0x10, 0x0F, 0x12, 0x11, 0x14, 0x13,  // second accelerometer
      0x16,          0x55,        0x18, 0x17, 0x1A, 0x99, 0xFF, 0x3F,  // encoders, the status in the upper two bits
      0x00,          0x00,        0x80, 0x3F, 0xD2, 0x04, 0xE0, 0xB1, 0x00,
      0x80,          0x00,        0x00,                                       // command, those of the canards
      0x22,          0x21,        0x26, 0x25, 0x24, 0x23,                     // duration, digest
      0x28,          0x27,        0x2A, 0x29, 0x2C, 0x2B, 0x2E, 0x2D, 0x01};  // second gyro
  std::array<std::byte, 64> bytes{};
  for (const std::size_t room : {59U, 50U}) {  // with the second gyro, and where there is no room for it
    bytes.fill(behind);
    SampleTimes times;
    pack(tick_of_known_bytes(), times, std::span{bytes}.first(room));
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      EXPECT_EQ(bytes.at(i), i < room ? std::byte{expected.at(i)} : behind) << "byte " << i << " of " << room;
    }
  }
}

TEST(LogTickLayout, EachFlagIsItsOwnBit) {
  const auto flags_of = [](const LogTick& tick) {
    SampleTimes times;
    return get<2>(pack(tick, times), 0);
  };
  constexpr DeviceStatus ok = DeviceStatus::ok;
  EXPECT_EQ(flags_of({.imu_status = ok, .accelerometer_status = ok}), 0U);
  EXPECT_EQ(flags_of({.imu_status = ok, .accelerometer_status = ok, .arm_switch_closed = true}), 0x0200U);
  EXPECT_EQ(flags_of({.imu_status = ok, .accelerometer_status = ok, .arm_command = true}), 0x0400U);
  EXPECT_EQ(flags_of({.imu_status = ok, .accelerometer_status = ok, .start_command = true}), 0x0800U);
  EXPECT_EQ(flags_of({.imu_status = ok, .accelerometer_status = ok, .saturated = true}), 0x1000U);
  EXPECT_EQ(flags_of({.imu_status = ok, .accelerometer_status = ok, .timing_fault = true}), 0x2000U);
  EXPECT_EQ(flags_of({.imu_status = ok, .accelerometer_status = ok, .abort = true}), 0x4000U);
}

// Bit by bit, so that none of them answers for another one.
TEST(LogTickLayout, EachFlagIsReadFromItsOwnBit) {
  for (unsigned bit = 9; bit < 16; ++bit) {
    SampleTimes times;
    PackedTick bytes = pack({.imu_status = DeviceStatus::ok, .accelerometer_status = DeviceStatus::ok}, times);
    put<2>(bytes, 0, 1U << bit);
    const auto tick = unpack_tick(time_of_tick, bytes, times);
    ASSERT_TRUE(tick) << bit;
    EXPECT_EQ(tick->arm_switch_closed, bit == 9) << bit;
    EXPECT_EQ(tick->arm_command, bit == 10) << bit;
    EXPECT_EQ(tick->start_command, bit == 11) << bit;
    EXPECT_EQ(tick->saturated, bit == 12) << bit;
    EXPECT_EQ(tick->timing_fault, bit == 13) << bit;
    EXPECT_EQ(tick->abort, bit == 14) << bit;
  }
}

TEST(LogTickLayout, ACommandGoesToTheNearestThousandthOfADegree) {
  LogTick tick;
  for (const auto& [degrees, counts] : std::vector<std::pair<float, std::uint16_t>>{
           {0.0004F, 0}, {0.0006F, 1}, {-0.0004F, 0}, {-0.0006F, 0xFFFF}, {2.0014F, 2001}, {-2.0016F, 63534}}) {
    tick.canard_commands[1] = Angle::from_degrees(degrees);
    SampleTimes times;
    EXPECT_EQ(get<2>(pack(tick, times), 38), counts) << degrees;
  }
}

TEST(LogTickLayout, ASampleOfThisVeryTickAndATickThatTookNoTimeAreKeptAsZeros) {
  const LogTick tick{.time = time_of_tick, .imu_time = time_of_tick, .accelerometer_time = time_of_tick};
  SampleTimes packing;
  const PackedTick bytes = pack(tick, packing);
  EXPECT_EQ(get<2>(bytes, 2), 0U);
  EXPECT_EQ(get<2>(bytes, 16), 0U);
  EXPECT_EQ(get<2>(bytes, 44), 0U);
  SampleTimes unpacking{.imu = Microseconds{1}, .accelerometer = Microseconds{2}};
  const auto back = unpack_tick(time_of_tick, bytes, unpacking);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->imu_time, time_of_tick);
  EXPECT_EQ(back->accelerometer_time, time_of_tick);
  EXPECT_EQ(back->duration_before, Microseconds{0});
}

// For the tick that follows, whose samples may be too old for their ages.
TEST(LogTickLayout, TheTimesOfTheSamplesAreHandedOn) {
  const LogTick tick = tick_of_known_bytes();
  std::array<std::byte, largest_log_tick> bytes{};
  SampleTimes packing;
  pack(tick, packing, bytes);
  SampleTimes unpacking;
  ASSERT_TRUE(unpack_tick(time_of_tick, bytes, unpacking));
  for (const SampleTimes& times : {packing, unpacking}) {
    EXPECT_EQ(times.imu, tick.imu_time);
    EXPECT_EQ(times.accelerometer, tick.accelerometer_time);
    EXPECT_EQ(times.second_gyro, tick.second_gyro->time);
  }
  pack({.time = time_of_tick, .second_gyro = LogSecondGyro{}}, packing, bytes);  // what was measured is too old
  const auto back = unpack_tick(time_of_tick, bytes, unpacking);
  ASSERT_TRUE(back && back->second_gyro);
  EXPECT_EQ(back->imu_time, tick.imu_time);
  EXPECT_EQ(back->accelerometer_time, tick.accelerometer_time);
  EXPECT_EQ(back->second_gyro->time, tick.second_gyro->time);
}

TEST(LogTickLayout, NoDeviceHasAFourthStatus) {
  const auto accepts = [](std::size_t at, std::uint32_t word) {
    SampleTimes times;
    PackedTick bytes = pack(tick_of_known_bytes(), times);
    put<2>(bytes, at, word);
    return unpack_tick(time_of_tick, bytes, times).has_value();
  };
  EXPECT_TRUE(accepts(0, 0x0040));   // the IMU has no reading
  EXPECT_FALSE(accepts(0, 0x0060));  // and what is more than that
  EXPECT_TRUE(accepts(0, 0x0100));   // likewise the second accelerometer
  EXPECT_FALSE(accepts(0, 0x0180));
  for (const std::size_t encoder : {24U, 26U, 28U, 30U}) {
    EXPECT_TRUE(accepts(encoder, 0xBFFF));
    EXPECT_FALSE(accepts(encoder, 0xC000));
  }
}

TEST(LogTickLayout, WhatLiesBehindATickIsNoneOfItsBusiness) {
  std::array<std::byte, 64> bytes{};
  bytes.fill(behind);
  SampleTimes packing;
  constexpr std::size_t with_two_gyros = log_tick_size_with(true, false);
  pack(tick_of_known_bytes(), packing, std::span{bytes}.first(with_two_gyros));
  for (const std::size_t size : {log_tick_size, with_two_gyros}) {
    SampleTimes times;
    const auto tick = unpack_tick(time_of_tick, std::span{bytes}.first(size), times);
    ASSERT_TRUE(tick);
    EXPECT_EQ(tick->digest, 0x23242526U);
    EXPECT_EQ(tick->second_gyro.has_value(), size == with_two_gyros);
    EXPECT_TRUE(!tick->second_gyro || tick->second_gyro->status == DeviceStatus::error);
  }
}

TEST(LogTickLayout, ATickOfWhichNothingIsSaidClaimsNothing) {
  const LogTick tick;
  EXPECT_FALSE(tick.arm_switch_closed || tick.arm_command || tick.start_command);
  EXPECT_FALSE(tick.saturated || tick.timing_fault || tick.abort || tick.second_gyro);
  EXPECT_EQ(tick.digest, 0U);
}

}  // namespace
}  // namespace fantail::protocol
