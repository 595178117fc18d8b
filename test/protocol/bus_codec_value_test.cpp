// SPDX-License-Identifier: MIT
// Numbers on their way into a frame and back: resolution, rounding, clamping, what is not a number.

#include "bus_rig.hpp"
#include "protocol/bus_choices.hpp"
#include "protocol/bus_codec.hpp"
#include "protocol/bus_core_choices.hpp"
#include "test.hpp"

namespace fantail::protocol {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

int signed_bits(const BusFrame& frame, unsigned start, unsigned length) {
  int value = 0;
  for (unsigned i = 0; i < length; ++i) {
    const unsigned bit = start + i;
    value |= ((frame.data[bit / 8U] >> (bit % 8U)) & 1) << i;
  }
  return value >= 1 << (length - 1U) ? value - (1 << length) : value;
}

BenchRequest one(std::size_t canard, float degrees) {
  BenchRequest request;
  request.angle[canard] = core::Angle::from_degrees(degrees);
  return request;
}

int counts(std::size_t canard, float degrees) {
  return signed_bits(encode(one(canard, degrees), 0, open_session), static_cast<unsigned>(12 * canard), 12);
}

TEST(BusCodecValue, EveryHundredthOfADegreeIsKeptExactlyForEveryCanard) {
  for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
    for (int k = -2047; k <= 2047; ++k) {
      const auto degrees = static_cast<float>(k * 0.01);
      const BusFrame frame = encode(one(canard, degrees), 5, open_session);
      ASSERT_EQ(signed_bits(frame, static_cast<unsigned>(12 * canard), 12), k);
      const auto decoded = decode_from_bench(frame, open_session);
      ASSERT_TRUE(decoded.message);
      const auto& request = std::get<BenchRequest>(*decoded.message);
      for (std::size_t i = 0; i < core::canard_count; ++i) {
        ASSERT_EQ(request.angle[i].has_value(), i == canard);
      }
      ASSERT_NEAR(static_cast<double>(request.angle[canard]->degrees()), k * 0.01, 4e-6);
    }
  }
}

TEST(BusCodecValue, AnAngleBetweenTwoHundredthsGoesToTheNearestOne) {
  for (int thousandth = -20'470; thousandth <= 20'470; ++thousandth) {
    const double exact = thousandth * 0.1;  // in hundredths
    if (std::abs(thousandth % 10) == 5) {
      continue;  // a half: the next test
    }
    ASSERT_EQ(counts(0, static_cast<float>(thousandth * 0.001)), std::lround(exact)) << thousandth;
  }
}

// A single has 24 bits, of which an angle near 20 degrees leaves about 2e-4 of a hundredth; a half that was told apart
// from both sides goes away from zero.
TEST(BusCodecValue, AHalfThatSinglePrecisionCannotTellGoesToOneOfItsNeighbours) {
  for (int k = -2046; k < 2046; ++k) {
    const int found = counts(0, static_cast<float>((k + 0.5) * 0.01));
    ASSERT_TRUE(found == k || found == k + 1) << k;
    ASSERT_EQ(counts(0, static_cast<float>((k + 0.498) * 0.01)), k);
    ASSERT_EQ(counts(0, static_cast<float>((k + 0.502) * 0.01)), k + 1);
  }
  MotionReport report;
  report.height_m = 0.25F;  // exactly half of 0.5 m
  EXPECT_EQ(signed_bits(encode(report), 32, 16), 1);
  report.height_m = -0.25F;
  EXPECT_EQ(signed_bits(encode(report), 32, 16), -1);
  report.height_m = 1000.75F;
  EXPECT_EQ(signed_bits(encode(report), 32, 16), 2002);
  report.height_m = -1000.75F;
  EXPECT_EQ(signed_bits(encode(report), 32, 16), -2002);
}

TEST(BusCodecValue, AnAngleBeyondTheFrameIsClampedAndNeverWraps) {
  for (const float degrees : {20.47F, 20.48F, 21.0F, 40.95F, 40.96F, 655.36F, 1e9F, 3e38F, infinity}) {
    for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
      EXPECT_EQ(counts(canard, degrees), 2047) << degrees;
      EXPECT_EQ(counts(canard, -degrees), -2047) << degrees;
    }
  }
}

TEST(BusCodecValue, ACanardAngleThatIsNotANumberIsAbsent) {
  for (const float wrong : {not_a_number, -not_a_number}) {
    BenchRequest request;
    request.angle.fill(core::Angle::from_degrees(3.0F));
    request.angle[2] = core::Angle::from_radians(wrong);
    const auto decoded = decode_from_bench(encode(request, 0, open_session), open_session);
    ASSERT_TRUE(decoded.message);
    const auto& angles = std::get<BenchRequest>(*decoded.message).angle;
    EXPECT_TRUE(angles[0] && angles[1] && angles[3]);
    EXPECT_FALSE(angles[2]);
  }
}

TEST(BusCodecValue, WhatElseIsNotANumberIsZero) {
  const auto angle = core::Angle::from_radians(not_a_number);
  EXPECT_EQ(
      encode(MotionReport{
          .roll_angle = angle, .roll_rate_rad_s = not_a_number, .height_m = not_a_number, .speed_m_s = not_a_number}),
      FrameBuilder{0x111}.plain());
  EXPECT_EQ(encode(LimitReport{.limit = {angle, angle, angle, angle}}), FrameBuilder{0x132}.plain());
  EXPECT_EQ(encode(StatusReport{.roll_command = angle}), FrameBuilder{0x110}.plain());
}

TEST(BusCodecValue, MotionIsClampedAtTheEndsOfItsSignals) {
  for (const float sign : {-1.0F, 1.0F}) {
    const BusFrame frame = encode(MotionReport{.roll_angle = core::Angle::from_degrees(sign * 1e6F),
                                               .roll_rate_rad_s = sign * 1000.0F,
                                               .height_m = sign * infinity,
                                               .speed_m_s = sign * 3e38F});
    for (const unsigned start : {0U, 16U, 32U, 48U}) {
      EXPECT_EQ(signed_bits(frame, start, 16), static_cast<int>(sign) * 32'767);
    }
  }
}

TEST(BusCodecValue, WhatElseIsReportedIsClampedAtTheEndsOfItsSignalToo) {
  for (const float sign : {-1.0F, 1.0F}) {
    const float rate_rad_s = sign * 1000.0F;
    const float force_m_s2 = sign * 1e6F;
    const BusFrame gyro = encode(GyroReport{.rate_rad_s = {rate_rad_s, rate_rad_s, rate_rad_s}});
    const BusFrame accelerometer =
        encode(AccelerometerReport{.specific_force_m_s2 = {force_m_s2, force_m_s2, force_m_s2}});
    for (const unsigned start : {0U, 16U, 32U}) {
      EXPECT_EQ(signed_bits(gyro, start, 16), static_cast<int>(sign) * 32'767);
      EXPECT_EQ(signed_bits(accelerometer, start, 16), static_cast<int>(sign) * 32'767);
    }
    const BusFrame status = encode(StatusReport{.roll_command = core::Angle::from_degrees(sign * 1e6F)});
    EXPECT_EQ(signed_bits(status, 24, 12), static_cast<int>(sign) * 2047);
  }
}

TEST(BusCodecValue, MotionKeepsItsResolution) {
  const auto decoded = decode_from_avionics(encode(MotionReport{.roll_angle = core::Angle::from_degrees(-1234.56F),
                                                                .roll_rate_rad_s = 6.2831853F,
                                                                .height_m = 812.3F,
                                                                .speed_m_s = -101.01F}));
  ASSERT_TRUE(decoded.message);
  const auto& motion = std::get<MotionReport>(*decoded.message);
  EXPECT_NEAR(motion.roll_angle.degrees(), -1234.6, 1e-3);
  EXPECT_NEAR(motion.roll_rate_rad_s, 6.2831853, 1e-5);  // 360 degrees a second is a whole count
  EXPECT_NEAR(motion.height_m, 812.5, 1e-4);
  EXPECT_NEAR(motion.speed_m_s, -101.0, 1e-4);
}

TEST(BusCodecValue, ALimitIsNeverNegative) {
  LimitReport report;
  report.limit = {core::Angle::from_degrees(-1.0F), core::Angle::from_degrees(9.0F), core::Angle::from_degrees(25.0F),
                  core::Angle::from_degrees(20.0F)};
  EXPECT_EQ(encode(report), FrameBuilder{0x132}.put(12, 12, 900).put(24, 12, 2047).put(36, 12, 2000).plain());
}

TEST(BusCodecValue, CountersThatDoNotFitLoseTheirUpperBits) {
  EXPECT_EQ(encode(BenchSession{}, 0x25), encode(BenchSession{}, 5));
  EXPECT_EQ(encode(HeartbeatReport{.uptime_ms = 0xAB123456U}), encode(HeartbeatReport{.uptime_ms = 0x123456U}));
}

TEST(BusCodecValue, APlaceThatDoesNotFitIsClamped) {
  EXPECT_EQ(encode(ArmReply{.canard = 1000}), encode(ArmReply{.canard = 3}));
  EXPECT_EQ(encode(LogRequest{.tag = 0x17, .size = 5000}, 0), encode(LogRequest{.tag = 7, .size = 4095}, 0));
  EXPECT_EQ(encode(HealthReport{.bus_state = 200}), encode(HealthReport{.bus_state = 4}));
  EXPECT_EQ(encode(BoardReport{.reset_cause = 200}), encode(BoardReport{.reset_cause = 4}));
}

TEST(BusChoices, WhatIsNoValueOfAnEnumerationHasNoChoice) {
  EXPECT_EQ(no_choice, 256U);  // no byte of a frame is that
  EXPECT_NE(protocol::choice(PlanBlockFault{}), no_choice);
  EXPECT_EQ(protocol::choice(static_cast<PlanBlockFault>(0xFF)), no_choice);
  EXPECT_EQ(protocol::choice(static_cast<Accelerometer>(0xFF)), no_choice);
  EXPECT_EQ(protocol::choice(static_cast<core::SensorState>(0xFF)), no_choice);
  EXPECT_EQ(protocol::choice(static_cast<core::SampleQuality>(0xFF)), no_choice);
}

}  // namespace
}  // namespace fantail::protocol
