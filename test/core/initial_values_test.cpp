// SPDX-License-Identifier: MIT
// What stands in the structures that are passed about before anybody has written into them: nothing is asked for,
// nothing has been measured, and nothing has happened.
#include <gtest/gtest.h>

#include "core/flight_plan.hpp"
#include "core/inputs.hpp"
#include "core/motion_estimator.hpp"
#include "core/tick_record.hpp"

namespace fantail::core {
namespace {

TEST(InitialValues, OfInputsAskForNothing) {
  const Inputs inputs;
  EXPECT_FALSE(inputs.arm_switch_closed);
  EXPECT_FALSE(inputs.arm_command);
  EXPECT_FALSE(inputs.start_command);
  EXPECT_FALSE(inputs.canard_request);
  EXPECT_FALSE(inputs.second_gyro);
  EXPECT_EQ(inputs.gyro.quality, SampleQuality::absent);
  for (const AccelerometerSample& sample : inputs.accelerometers) {
    EXPECT_EQ(sample.quality, SampleQuality::absent);
  }
  for (const auto& encoder : inputs.encoders) {
    EXPECT_FALSE(encoder);
  }
}

TEST(InitialValues, OfAVectorAreZero) {
  const Vector3 vector;
  EXPECT_EQ(vector.x, 0.0F);
  EXPECT_EQ(vector.y, 0.0F);
  EXPECT_EQ(vector.z, 0.0F);
}

TEST(InitialValues, OfAMotionAreThoseOfRestWithoutASensor) {
  const Motion motion;
  EXPECT_EQ(motion.roll_angle, Angle{});
  EXPECT_EQ(motion.roll_rate_rad_s, 0.0F);
  EXPECT_EQ(motion.height_m, 0.0F);
  EXPECT_EQ(motion.distance_along_guide_m, 0.0F);
  EXPECT_EQ(motion.speed_m_s, 0.0F);
  EXPECT_EQ(motion.vertical_speed_m_s, 0.0F);
  EXPECT_EQ(motion.tilt, Angle{});
  EXPECT_EQ(motion.gyro, SensorState::failed);
  EXPECT_EQ(motion.accelerometer, SensorState::failed);
  EXPECT_FALSE(motion.rate_is_lower_bound);
  EXPECT_FALSE(motion.roll_is_bridged);
  EXPECT_FALSE(motion.speed_is_lower_bound);
}

TEST(InitialValues, OfARecordHaveNeitherAFaultNorAMissedTickNorALimit) {
  const TickRecord record;
  EXPECT_EQ(record.command_status, CommandStatus::outside_control);
  EXPECT_FALSE(record.timing_fault);
  EXPECT_EQ(record.overruns, 0U);
  EXPECT_FALSE(record.saturated);
  EXPECT_FALSE(record.gyro_vote);
  EXPECT_FALSE(record.canard_angle);
}

// A rocket with four canards, and two accelerometers.
TEST(Limits, ThereAreFourCanardsAndTwoAccelerometers) {
  EXPECT_EQ(canard_count, 4U);
  EXPECT_EQ(Inputs{}.accelerometers.size(), 2U);
}

// As the manual says of a plan.
TEST(Limits, APlanHasRoomForSixRowsOfGainsAndEightStepsAndNoCanardGoesBeyondTwentyDegrees) {
  EXPECT_EQ(most_schedule_rows, 6U);
  EXPECT_EQ(most_reference_steps, 8U);
  EXPECT_NEAR(hard_canard_limit.radians(), 0.3490658504F, 1e-7F);
}

// 1000 g and 16 turns a second, rounded; the standard's gravity.
TEST(Limits, TheLargestThatIsAMeasurementIsThatOfAnySensorThatFitsARocket) {
  EXPECT_EQ(largest_specific_force_m_s2, 10'000.0F);
  EXPECT_EQ(largest_rate_rad_s, 100.0F);
  EXPECT_EQ(standard_gravity_m_s2, 9.80665F);
}

}  // namespace
}  // namespace fantail::core
