// SPDX-License-Identifier: MIT

#include "protocol/bus_messages.hpp"

#include "bus_rig.hpp"
#include "protocol/bus_angle_frame.hpp"
#include "protocol/bus_codec.hpp"
#include "protocol/bus_frames.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::protocol {
namespace {

template <typename Message>
void expect_zeros(std::uint16_t id) {
  EXPECT_EQ(encode_any(Message{}, 0), FrameBuilder{id}.done()) << std::hex << id;
}

// What nobody has set must not look like a report of something.
TEST(BusMessages, OneOfWhichNothingIsSaidIsAFrameOfZeros) {
  expect_zeros<BenchRequest>(0x010);
  expect_zeros<BenchSession>(0x020);
  expect_zeros<ArmRequest>(0x030);
  expect_zeros<PlanBegin>(0x040);
  expect_zeros<PlanData>(0x041);
  expect_zeros<LogRequest>(0x050);
  expect_zeros<CommandReport>(0x100);
  expect_zeros<EncoderReport>(0x101);
  expect_zeros<StatusReport>(0x110);
  expect_zeros<MotionReport>(0x111);
  expect_zeros<SessionReply>(0x120);
  expect_zeros<ArmReply>(0x121);
  expect_zeros<PlanReply>(0x122);
  expect_zeros<LogReply>(0x123);
  expect_zeros<RejectionReport>(0x131);
  expect_zeros<LimitReport>(0x132);
  expect_zeros<BoardReport>(0x133);
  expect_zeros<LogData>(0x180);
}

// But for a sensor of which nothing is known, which is a failed one, and the version.
TEST(BusMessages, ASensorOfWhichNothingIsSaidHasFailedOrIsAbsent) {
  EXPECT_EQ(encode(HealthReport{}), FrameBuilder{0x130}.put(16, 2, 3).put(18, 2, 3).plain());
  EXPECT_EQ(encode(GyroReport{}), FrameBuilder{0x134}.put(62, 2, 3).plain());
  EXPECT_EQ(encode(AccelerometerReport{}), FrameBuilder{0x135}.put(62, 2, 3).plain());
}

// Values in which each signal has bits of its own, up to its last one.
TEST(BusMessages, WhatIsSaidLiesInItsOwnSignal) {
  EXPECT_EQ(encode(ArmRequest{.nonce = 0x89ABCDEF}, 5),
            FrameBuilder{0x030}.put(16, 32, 0x89ABCDEF).put(52, 4, 5).with_crc());
  EXPECT_EQ(encode(LogRequest{.tag = 9, .offset = 0x89ABCDEF, .size = 4095}, 5),
            FrameBuilder{0x050}.put(4, 4, 9).put(8, 32, 0x89ABCDEF).put(40, 12, 4095).put(52, 4, 5).with_crc());
  EXPECT_EQ(encode(LogRequest{.tag = 15}, 0), FrameBuilder{0x050}.put(4, 4, 15).with_crc());
  EXPECT_EQ(encode(ArmReply{.nonce = 0x89ABCDEF}), FrameBuilder{0x121}.put(20, 1, 1).put(32, 32, 0x89ABCDEF).plain());
  EXPECT_EQ(encode(BoardReport{.flash_failed = true, .overruns = 0x81}),
            FrameBuilder{0x133}.put(48, 8, 0x81).put(63, 1, 1).plain());
  EXPECT_EQ(encode(GyroReport{.quality = core::SampleQuality::valid, .time_ms = 16'383}),
            FrameBuilder{0x134}.put(48, 14, 16'383).plain());
  EXPECT_EQ(encode(GyroReport{.quality = core::SampleQuality::valid, .time_ms = 16'384}), FrameBuilder{0x134}.plain());
  EXPECT_EQ(encode(HeartbeatReport{.uptime_ms = 0xFFFFFF, .plan_crc = 0x89ABCDEF}),
            FrameBuilder{0x140}.put(0, 8, 2).put(8, 24, 0xFFFFFF).put(32, 32, 0x89ABCDEF).plain());
  EXPECT_EQ(encode(HeartbeatReport{.uptime_ms = 0x01000001}), FrameBuilder{0x140}.put(0, 8, 2).put(8, 24, 1).plain());
}

// docs/can.md describes version 2, chunks of 256 * 7 bytes and six causes of a rejection.
TEST(BusMessages, TheNumbersOfTheProtocolAreThoseOfItsManual) {
  EXPECT_EQ(encode(HeartbeatReport{}), FrameBuilder{0x140}.put(0, 8, 2).plain());
  EXPECT_EQ(largest_log_chunk, 1792);
  EXPECT_EQ(rejection_count, 6U);
  EXPECT_EQ(RejectionReport{}.count.size(), static_cast<std::size_t>(Rejection::stale) + 1);
}

// The signals by the database's own scale, packed by the functions that are generated from it.
BusFrame generated(std::uint16_t id, const PerCanard& angles, std::uint8_t counter) {
  CommandReportFrame::Raw raw{};
  raw.counter = counter;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (angles[i] && !std::isnan(angles[i]->radians())) {
      raw.*signals::driven.angle[i] = CanardAngle{}.raw(angles[i]->degrees());
      raw.*signals::driven.given[i] = 1;
    }
  }
  FrameBuilder frame{id};
  const BusFrame packed = CommandReportFrame::pack(raw);
  for (unsigned i = 0; i < packed.data.size(); ++i) {
    frame.put(8 * i, 8, packed.data[i]);
  }
  return frame.with_crc();
}

std::optional<core::Angle> any_angle(std::mt19937& random) {
  switch (std::uniform_int_distribution{0, 9}(random)) {
    case 0: return std::nullopt;
    case 1: return core::Angle::from_radians(std::numeric_limits<float>::quiet_NaN());
    case 2: return core::Angle::from_radians(-std::numeric_limits<float>::infinity());
    case 3: return core::Angle::from_degrees(std::uniform_real_distribution{-1e6F, 1e6F}(random));
    case 4:
      return core::Angle::from_degrees(0.005F * static_cast<float>(std::uniform_int_distribution{-4100, 4100}(random)));
    default: return core::Angle::from_degrees(std::uniform_real_distribution{-21.0F, 21.0F}(random));
  }
}

TEST(AngleFrame, IsBitForBitWhatTheGeneratedFunctionsMakeOfTheSameAngles) {
  std::mt19937 random{test::seed()};
  for (int i = 0; i < 100'000; ++i) {
    const PerCanard angles{any_angle(random), any_angle(random), any_angle(random), any_angle(random)};
    const auto counter = static_cast<std::uint8_t>(std::uniform_int_distribution{0, 15}(random));
    ASSERT_EQ(angle_frame(CommandReportFrame::id, angles, counter), generated(CommandReportFrame::id, angles, counter));
    ASSERT_EQ(angle_frame(EncoderReportFrame::id, angles, counter), generated(EncoderReportFrame::id, angles, counter));
    ASSERT_EQ(angle_frame(BenchRequestFrame::id, angles, counter, open_session),
              generated(BenchRequestFrame::id, angles, counter));
  }
}

}  // namespace

}  // namespace fantail::protocol
