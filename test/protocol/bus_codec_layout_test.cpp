// SPDX-License-Identifier: MIT
// Every signal of every frame, each through all the values it can have (dbc_test.py looks at what the values mean).
#include <ostream>

#include "bus_rig.hpp"
#include "protocol/bus_codec.hpp"
#include "test.hpp"

namespace fantail::protocol {
namespace {

struct Signal {
  unsigned start;
  unsigned length;
  std::int64_t lowest;
  std::int64_t highest;
};

struct Frame {
  const char* name;
  std::uint16_t id;
  std::vector<Signal> signals;
  std::vector<unsigned> always;  ///< bits without which another signal has no meaning
  friend std::ostream& operator<<(std::ostream& out, const Frame& frame) { return out << frame.name; }
};

Signal whole(unsigned start, unsigned length) { return {start, length, 0, (std::int64_t{1} << length) - 1}; }
Signal choice(unsigned start, unsigned length, int count) { return {start, length, 0, count - 1}; }
Signal symmetric(unsigned start, unsigned length) {
  const std::int64_t highest = (std::int64_t{1} << (length - 1)) - 1;
  return {start, length, -highest, highest};
}
std::vector<Signal> four_angles() {
  return {symmetric(0, 12), symmetric(12, 12), symmetric(24, 12), symmetric(36, 12), whole(52, 4)};
}
std::vector<Signal> all_bytes() {
  return {whole(0, 8), whole(8, 8), whole(16, 8), whole(24, 8), whole(32, 8), whole(40, 8), whole(48, 8), whole(56, 8)};
}

const std::vector<Frame>& frames() {
  static const std::vector<Frame> all{
      {"BenchRequest", 0x010, four_angles(), {48, 49, 50, 51}},
      {"BenchSession", 0x020, {choice(0, 8, 3), whole(16, 16), whole(52, 4)}, {}},
      {"ArmRequest", 0x030, {choice(0, 8, 4), whole(16, 32), whole(52, 4)}, {}},
      {"PlanBegin", 0x040, {whole(0, 16), whole(16, 32), whole(52, 4)}, {}},
      {"PlanData", 0x041, all_bytes(), {}},
      {"LogRequest", 0x050, {choice(0, 4, 4), whole(4, 4), whole(8, 32), whole(40, 12), whole(52, 4)}, {}},
      {"CommandReport", 0x100, four_angles(), {48, 49, 50, 51}},
      {"EncoderReport", 0x101, four_angles(), {48, 49, 50, 51}},
      {"StatusReport",
       0x110,
       {choice(0, 8, 6), choice(8, 8, 23), choice(16, 8, 4), symmetric(24, 12), whole(36, 1), whole(37, 1),
        whole(38, 1), whole(39, 1), whole(40, 1), whole(41, 1), whole(42, 1), whole(43, 1), whole(44, 1), whole(45, 1),
        whole(46, 1), whole(47, 1), symmetric(48, 12)},
       {}},
      {"MotionReport", 0x111, {symmetric(0, 16), symmetric(16, 16), symmetric(32, 16), symmetric(48, 16)}, {}},
      {"SessionReply", 0x120, {choice(0, 8, 2), choice(8, 8, 9), whole(16, 16)}, {}},
      {"ArmReply",
       0x121,
       {choice(0, 8, 4), choice(8, 8, 21), choice(16, 4, 5), choice(21, 2, 4), choice(24, 8, 14), whole(32, 32)},
       {20}},
      {"PlanReply", 0x122, {choice(0, 8, 5), choice(8, 8, 8), whole(16, 8), choice(24, 8, 9), whole(32, 8)}, {40}},
      {"LogReply", 0x123, {choice(0, 4, 5), choice(4, 4, 7), whole(8, 4), whole(16, 32), whole(48, 16)}, {}},
      {"HealthReport",
       0x130,
       {choice(0, 4, 5), choice(4, 4, 5), choice(8, 4, 5), choice(12, 4, 5), choice(16, 2, 4), choice(18, 2, 4),
        choice(20, 4, 5), whole(24, 8), whole(32, 8), whole(40, 8), whole(48, 16)},
       {}},
      {"RejectionReport",
       0x131,
       {whole(0, 8), whole(8, 8), whole(16, 8), whole(24, 8), whole(32, 8), whole(40, 8)},
       {}},
      {"LimitReport", 0x132, {{0, 12, 0, 2047}, {12, 12, 0, 2047}, {24, 12, 0, 2047}, {36, 12, 0, 2047}}, {}},
      {"BoardReport",
       0x133,
       {whole(0, 32), whole(32, 16), whole(48, 8), choice(56, 3, 5), choice(59, 3, 5), whole(63, 1)},
       {62}},
      {"GyroReport",
       0x134,
       {symmetric(0, 16), symmetric(16, 16), symmetric(32, 16), whole(48, 14), choice(62, 2, 4)},
       {}},
      {"AccelerometerReport",
       0x135,
       {symmetric(0, 16), symmetric(16, 16), symmetric(32, 16), whole(48, 1), choice(62, 2, 4)},
       {}},
      {"HeartbeatReport", 0x140, {whole(0, 8), whole(8, 24), whole(32, 32)}, {}},
      {"LogData", 0x180, all_bytes(), {}}};
  return all;
}

FrameBuilder empty(const Frame& frame) {
  FrameBuilder builder{frame.id};
  for (const unsigned bit : frame.always) {
    builder.put(bit, 1, 1);
  }
  return builder;
}

class BusCodecLayout : public testing::TestWithParam<Frame> {};

// Signals of up to 16 bits through every bit pattern, longer ones through a walk that reaches every bit.
TEST_P(BusCodecLayout, EverySignalKeepsEveryValueOfItsRangeAndRefusesEveryOther) {
  const Frame& frame = GetParam();
  for (const Signal& signal : frame.signals) {
    const std::int64_t lowest = signal.lowest < 0 ? signal.lowest - 1 : 0;
    const std::int64_t count = std::int64_t{1} << signal.length;
    const std::int64_t step = signal.length <= 16 ? 1 : 65'521 / 8;  // prime, so that the low bits vary too
    for (std::int64_t value = lowest; value < lowest + count; value += step) {
      const BusFrame sent = empty(frame).put(signal.start, signal.length, value).done();
      const auto back = there_and_back(sent);
      if (value >= signal.lowest && value <= signal.highest) {
        ASSERT_TRUE(std::holds_alternative<BusFrame>(back)) << "bit " << signal.start << " value " << value;
        ASSERT_EQ(std::get<BusFrame>(back), sent) << "bit " << signal.start << " value " << value;
      } else {
        ASSERT_TRUE(std::holds_alternative<Rejection>(back)) << "bit " << signal.start << " value " << value;
        ASSERT_EQ(std::get<Rejection>(back), Rejection::out_of_range);
      }
    }
  }
}

// Bits of no signal: the bench must send zeros, and what newer avionics put there is not looked at.
TEST_P(BusCodecLayout, BitsOfNoSignalAreRefusedFromTheBenchOnly) {
  const Frame& frame = GetParam();
  std::uint64_t used = 0;
  const bool has_crc = frame.id <= 0x040 || frame.id == 0x050 || frame.id == 0x100 || frame.id == 0x101;
  for (const Signal& signal : frame.signals) {
    used |= ((std::uint64_t{1} << signal.length) - 1) << signal.start;
  }
  for (const unsigned bit : frame.always) {
    used |= std::uint64_t{1} << bit;
  }
  for (unsigned bit = 0; bit < (has_crc ? 56U : 64U); ++bit) {
    if (((used >> bit) & 1U) != 0U) {
      continue;
    }
    const auto back = there_and_back(empty(frame).put(bit, 1, 1).done());
    if (frame.id < 0x100) {
      ASSERT_TRUE(std::holds_alternative<Rejection>(back)) << bit;
      EXPECT_EQ(std::get<Rejection>(back), Rejection::out_of_range);
    } else {
      ASSERT_TRUE(std::holds_alternative<BusFrame>(back)) << bit;
      EXPECT_EQ(std::get<BusFrame>(back), empty(frame).done());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Frames, BusCodecLayout, testing::ValuesIn(frames()),
                         [](const auto& test) { return std::string{test.param.name}; });

TEST(BusCodecFlags, EachFlagOfFourAnglesIsItsOwnCanard) {
  for (unsigned flags = 0; flags < 16; ++flags) {
    for (const std::uint16_t id : {std::uint16_t{0x010}, std::uint16_t{0x100}, std::uint16_t{0x101}}) {
      const BusFrame frame = FrameBuilder{id}.put(48, 4, flags).put(52, 4, 9).with_crc();
      PerCanard angles{};
      if (id == 0x010) {
        angles = std::get<BenchRequest>(decode_from_bench(frame, open_session).message.value()).angle;
      } else if (id == 0x100) {
        angles = std::get<CommandReport>(decode_from_avionics(frame).message.value()).angle;
      } else {
        angles = std::get<EncoderReport>(decode_from_avionics(frame).message.value()).angle;
      }
      for (unsigned i = 0; i < 4; ++i) {
        EXPECT_EQ(angles[i].has_value(), ((flags >> i) & 1U) != 0U);
      }
      EXPECT_EQ(std::get<BusFrame>(there_and_back(frame)), frame);
    }
  }
}

TEST(BusCodecFlags, TheAngleOfACanardThatIsNotAskedMustBeZero) {
  for (unsigned canard = 0; canard < 4; ++canard) {
    const BusFrame frame = FrameBuilder{0x010}.put(48, 4, 0xF & ~(1U << canard)).put(12 * canard, 12, 1).with_crc();
    EXPECT_EQ(std::get<Rejection>(there_and_back(frame)), Rejection::out_of_range);
  }
}

TEST(BusCodecFlags, AReportedAngleWithoutItsFlagIsAbsent) {
  const BusFrame frame = FrameBuilder{0x101}.put(48, 4, 0b1101).put(12, 12, -300).with_crc();
  const auto report = std::get<EncoderReport>(decode_from_avionics(frame).message.value());
  EXPECT_FALSE(report.angle[1]);
  EXPECT_TRUE(report.angle[0]);
}

TEST(BusCodecFlags, ANonceAFieldAndABatteryAreThereOnlyWithTheirFlag) {
  EXPECT_EQ(std::get<ArmReply>(decode_from_avionics(FrameBuilder{0x121}.put(32, 32, 77).plain()).message.value()).nonce,
            std::nullopt);
  EXPECT_EQ(encode(ArmReply{.nonce = 0}), FrameBuilder{0x121}.put(20, 1, 1).plain());
  EXPECT_EQ(std::get<PlanReply>(decode_from_avionics(FrameBuilder{0x122}.put(32, 8, 77).plain()).message.value()).field,
            std::nullopt);
  EXPECT_EQ(encode(PlanReply{.field = 0}), FrameBuilder{0x122}.put(40, 1, 1).plain());
  EXPECT_EQ(std::get<BoardReport>(decode_from_avionics(FrameBuilder{0x133}.put(32, 16, 77).plain()).message.value())
                .battery_mv,
            std::nullopt);
  EXPECT_EQ(encode(BoardReport{.battery_mv = std::uint16_t{0}}), FrameBuilder{0x133}.put(62, 1, 1).plain());
}

TEST(BusCodecFlags, WhatIsAbsentLeavesNothingInItsPlace) {
  EXPECT_EQ(encode(ArmReply{}), FrameBuilder{0x121}.plain());
  EXPECT_EQ(encode(PlanReply{}), FrameBuilder{0x122}.plain());
  EXPECT_EQ(encode(BoardReport{}), FrameBuilder{0x133}.plain());
}

}  // namespace
}  // namespace fantail::protocol
