// SPDX-License-Identifier: MIT

#include "avionics/sensor_scaling.hpp"

#include "avionics/mounting.hpp"
#include "core/flight_plan_fields.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using namespace core::literals;
using core::SampleQuality;
using hal::Microseconds;
using hal::Status;

constexpr std::int16_t lowest = -32768;
constexpr std::int16_t highest = 32767;
constexpr hal::ImuScale scale{.rate_rad_s = 0.001F, .specific_force_m_s2 = 0.005F};

hal::ImuSample imu_with(hal::Counts rate, Status status = Status::ok) {
  return {.time = Microseconds{77}, .rate = rate, .specific_force = {}, .status = status};
}

SampleQuality axial_quality(std::int16_t count, Status status = Status::ok) {
  return accelerometer_sample(Microseconds{5}, {count, 0, 0}, status, 0.005F).quality;
}

hal::EncoderReading encoders_at(std::array<std::uint16_t, 4> counts, Status status = Status::ok) {
  hal::EncoderReading reading;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    reading.each[i] = {.counts = counts[i], .status = status};
  }
  return reading;
}

TEST(SensorScaling, CountsBecomeSiUnitsWithTheirSignAxisAndTime) {
  const core::GyroSample gyro = gyro_sample(imu_with({1000, -2000, 3}), scale);
  EXPECT_FLOAT_EQ(gyro.rate_rad_s.x, 1.0F);
  EXPECT_FLOAT_EQ(gyro.rate_rad_s.y, -2.0F);
  EXPECT_FLOAT_EQ(gyro.rate_rad_s.z, 0.003F);
  EXPECT_EQ(gyro.time, Microseconds{77});
  EXPECT_EQ(gyro.quality, SampleQuality::valid);

  const auto force = accelerometer_sample(Microseconds{78}, {2000, -4, 6}, Status::ok, 0.005F);
  EXPECT_FLOAT_EQ(force.specific_force_m_s2.x, 10.0F);
  EXPECT_FLOAT_EQ(force.specific_force_m_s2.y, -0.02F);
  EXPECT_FLOAT_EQ(force.specific_force_m_s2.z, 0.03F);
  EXPECT_EQ(force.time, Microseconds{78});
  EXPECT_EQ(force.quality, SampleQuality::valid);
}

TEST(SensorScaling, AGyroAtAnEndOfItsRollAxisIsSaturatedAndOfAnotherInvalid) {
  for (const std::int16_t end : {lowest, highest}) {
    EXPECT_EQ(gyro_sample(imu_with({end, 0, 0}), scale).quality, SampleQuality::saturated);
    EXPECT_EQ(gyro_sample(imu_with({0, end, 0}), scale).quality, SampleQuality::invalid);
    EXPECT_EQ(gyro_sample(imu_with({0, 0, end}), scale).quality, SampleQuality::invalid);
    EXPECT_EQ(gyro_sample(imu_with({end, 0, end}), scale).quality, SampleQuality::invalid);
  }
  EXPECT_EQ(gyro_sample(imu_with({lowest, lowest, lowest}), scale).quality, SampleQuality::invalid)
      << "what an IMU holds before its first sample";
  EXPECT_EQ(gyro_sample(imu_with({32766, -32767, 0}), scale).quality, SampleQuality::valid);
}

TEST(SensorScaling, AnAccelerometerIsSaturatedAtItsAxialPositiveEndOnly) {
  EXPECT_EQ(axial_quality(highest), SampleQuality::saturated);
  EXPECT_EQ(axial_quality(highest - 1), SampleQuality::valid);
  EXPECT_EQ(axial_quality(lowest), SampleQuality::invalid) << "a bound of no use";
  EXPECT_FLOAT_EQ(accelerometer_sample({}, {highest, 0, 0}, Status::ok, 0.005F).specific_force_m_s2.x, 163.835F)
      << "full scale is what gets integrated";
}

TEST(SensorScaling, WhatTheDeviceSaidAboutItselfOutranksItsCounts) {
  EXPECT_EQ(gyro_sample(imu_with({highest, 0, 0}, Status::no_reading), scale).quality, SampleQuality::absent);
  EXPECT_EQ(gyro_sample(imu_with({1, 2, 3}, Status::error), scale).quality, SampleQuality::invalid);
  EXPECT_EQ(axial_quality(highest, Status::error), SampleQuality::invalid);
  EXPECT_EQ(axial_quality(highest, Status::no_reading), SampleQuality::absent);
}

TEST(SensorScaling, EncoderAnglesAreSignedAboutTheZeroOfThePlan) {
  core::CanardsPlan plan = core::default_plan().canards;
  plan.each[1].encoder_zero = 90_deg;
  plan.each[2].encoder_zero = -90_deg;
  plan.each[3].encoder_zero = 179_deg;
  // 16384 counts a turn: 512 are 11.25 degrees.
  const core::EncoderAngles angles = encoder_angles(encoders_at({512, 4096 + 512, 12288 - 512, 8192 + 512}), plan);
  EXPECT_NEAR(angles[0]->degrees(), 11.25F, 1e-4F);
  EXPECT_NEAR(angles[1]->degrees(), 11.25F, 1e-4F);
  EXPECT_NEAR(angles[2]->degrees(), -11.25F, 1e-4F);
  EXPECT_NEAR(angles[3]->degrees(), 12.25F, 1e-4F);
}

TEST(SensorScaling, EncoderAnglesWrapAt180DegreesWhateverTheirZero) {
  core::CanardsPlan plan = core::default_plan().canards;
  for (const float zero_deg : {-180.0F, -179.99F, -90.0F, -1.0F, 0.0F, 1.0F, 90.0F, 179.99F, 180.0F}) {
    plan.each[0].encoder_zero = core::Angle::from_degrees(zero_deg);
    for (std::uint16_t counts = 0; counts < hal::encoder_counts_per_turn; ++counts) {
      const float angle_deg = encoder_angles(encoders_at({counts, 0, 0, 0}), plan)[0]->degrees();
      const double expected = std::remainder(counts * 360.0 / 16384.0 - static_cast<double>(zero_deg), 360.0);
      ASSERT_LE(std::abs(angle_deg), 180.0001F) << counts << " about " << zero_deg;
      ASSERT_NEAR(std::remainder(static_cast<double>(angle_deg) - expected, 360.0), 0.0, 1e-4) << counts;
    }
  }
  EXPECT_FLOAT_EQ(encoder_angles(encoders_at({8192, 0, 0, 0}), core::default_plan().canards)[0]->degrees(), 180.0F);
}

TEST(SensorScaling, AnEncoderWithoutAValidReadingIsEmptyAndAlone) {
  hal::EncoderReading reading = encoders_at({100, 100, 100, 100});
  reading.each[0].status = Status::error;
  reading.each[1].status = Status::no_reading;
  reading.each[2].counts = hal::encoder_counts_per_turn;  // no such position on one turn
  const core::EncoderAngles angles = encoder_angles(reading, core::default_plan().canards);
  EXPECT_FALSE(angles[0].has_value());
  EXPECT_FALSE(angles[1].has_value());
  EXPECT_FALSE(angles[2].has_value());
  EXPECT_TRUE(angles[3].has_value());
}

TEST(SensorScaling, PulsesAreRoundedToTheNearestNanosecond) {
  core::CanardCommands commands;
  const float widths_us[] = {1500.0F, 1500.1251F, 899.9996F, 2099.9998F};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    commands[i] = {.angle = {}, .pulse_us = widths_us[i], .driven = true};
  }
  const auto result = pulses(commands);
  for (std::size_t i = 0; i < result.size(); ++i) {
    EXPECT_EQ(result[i]->count(), std::lround(static_cast<double>(widths_us[i]) * 1000.0)) << widths_us[i];
  }
}

TEST(SensorScaling, PulsesKeepTheirNanosecondOverTheWholeRangeOfAPlan) {
  core::CanardCommands commands;
  for (int i = 0; i < 75'000; ++i) {
    const float width_us = 100.0F + 0.0371F * static_cast<float>(i);
    commands[0] = {.angle = {}, .pulse_us = width_us, .driven = true};
    ASSERT_NEAR(static_cast<double>(pulses(commands)[0]->count()), static_cast<double>(width_us) * 1000.0, 0.63);
  }
}

TEST(SensorScaling, ACanardThatIsNotDrivenGetsNoPulse) {
  core::CanardCommands commands;
  commands[2] = {.angle = {}, .pulse_us = 1500.0F, .driven = true};
  const auto result = pulses(commands);
  EXPECT_FALSE(result[0].has_value());
  EXPECT_TRUE(result[2].has_value());
  EXPECT_FALSE(result[3].has_value());
}

using core::SensorAxis;
using enum SensorAxis;
using hal::Counts;

TEST(Mounting, TurnsTheSensorsAxesIntoTheRockets) {
  // The sensor's y to the nose, its x to the rocket's -y.
  constexpr Mounting mounting{{.to_nose = plus_y, .along_y = minus_x}};
  EXPECT_EQ(mounting.turned({1, 2, 3}), (Counts{2, -1, 3}));
}

TEST(Mounting, FullScaleStaysFullScaleWhenItsSignChanges) {
  constexpr Mounting mounting{{.to_nose = minus_x, .along_y = minus_y}};
  EXPECT_EQ(mounting.turned({32767, -32768, 7}), (Counts{-32768, 32767, 7}));
  EXPECT_EQ(mounting.turned({-32767, 32766, 7}), (Counts{32767, -32766, 7}));
}

TEST(Mounting, NothingToBeUsedStaysNothingToBeUsed) {
  constexpr Mounting mounting{{.to_nose = minus_x, .along_y = minus_y}};
  EXPECT_EQ(mounting.turned(hal::no_counts), hal::no_counts);
}

TEST(Mounting, HasTwentyFourWaysToSitAndNeverMirrors) {
  // A cube can be put down on six faces and turned to four sides. What is turned keeps its handedness: with the images
  // of the sensor's x, y and z as columns the determinant is 1.
  std::set<Counts> seen;
  constexpr std::array axes{plus_x, minus_x, plus_y, minus_y, plus_z, minus_z};
  for (const SensorAxis to_nose : axes) {
    for (const SensorAxis along_y : axes) {
      if (static_cast<int>(to_nose) / 2 == static_cast<int>(along_y) / 2) {
        continue;  // no plan may say so
      }
      const Mounting mounting{{.to_nose = to_nose, .along_y = along_y}};
      const Counts a = mounting.turned({1, 0, 0});
      const Counts b = mounting.turned({0, 1, 0});
      const Counts c = mounting.turned({0, 0, 1});
      EXPECT_EQ(
          a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]),
          1);
      seen.insert(mounting.turned({1, 2, 3}));
    }
  }
  EXPECT_EQ(seen.size(), 24U);
}

}  // namespace

}  // namespace fantail::avionics
