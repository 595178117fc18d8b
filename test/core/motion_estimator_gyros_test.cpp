// SPDX-License-Identifier: MIT

#include "core/flight_plan_fields.hpp"
#include "core/motion_estimator.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

FlightPlan flies_on_two() {
  FlightPlan plan = default_plan();
  plan.sensors.gyros = GyroRule::two_agree;
  plan.sensors.gyro_disagreement_rad_s = 0.25F;
  plan.motion.stale_time = Microseconds{5'000};
  return plan;
}

/// An estimator that follows two gyros, once a millisecond.
class TwoGyros {
 public:
  GyroSample at(float roll_rate_rad_s, int age_us = 0) const {
    return {.time = now - Microseconds{age_us},
            .rate_rad_s = {roll_rate_rad_s, 0.0F, 0.0F},
            .quality = SampleQuality::valid};
  }
  GyroVote tick(const GyroSample& first, const GyroSample& second) {
    Inputs inputs;
    inputs.time = now;
    inputs.gyro = first;
    inputs.second_gyro = second;
    estimator.update(inputs);
    now += Microseconds{1'000};
    return estimator.gyro_vote();
  }
  [[nodiscard]] Motion motion() const { return estimator.motion(now); }

  Microseconds now{10'000};
  MotionEstimator estimator{flies_on_two().motion, flies_on_two().sensors};
};

TEST(MotionGyros, OneThatIsOlderThanTheOtherByMoreThanHalfTheStaleTimeIsNotFlownOn) {
  TwoGyros gyros;
  EXPECT_EQ(gyros.tick(gyros.at(1.0F, 2'500), gyros.at(1.0F)), GyroVote::both);
  EXPECT_EQ(gyros.tick(gyros.at(1.0F, 2'501), gyros.at(1.0F)), GyroVote::second);
}

TEST(MotionGyros, TheVeryFirstSampleOnThePadSaysWhatTheSecondReadsMore) {
  TwoGyros gyros;
  EXPECT_EQ(gyros.tick(gyros.at(0.25F), gyros.at(0.375F)), GyroVote::both);
  EXPECT_EQ(gyros.tick({}, gyros.at(0.375F)), GyroVote::second);
  EXPECT_EQ(gyros.motion().roll_rate_rad_s, 0.25F);
}

TEST(MotionGyros, OneThatSaysZeroFromTheBeginningIsBelievedForEightSamplesAndNotForTen) {
  TwoGyros gyros;
  for (int i = 1; i <= 10; ++i) {
    const GyroVote vote = gyros.tick(gyros.at(0.0F), gyros.at(i % 2 == 0 ? 0.1F : -0.1F));
    if (i <= 8 || i == 10) {
      EXPECT_EQ(vote, i <= 8 ? GyroVote::both : GyroVote::second) << i;
    }
  }
}

TEST(MotionGyros, BeforeTheFirstSampleNothingIsKnownAndNothingIsBridgedOrABound) {
  TwoGyros gyros;
  const Motion motion = gyros.motion();
  EXPECT_EQ(motion.gyro, SensorState::failed);
  EXPECT_EQ(motion.accelerometer, SensorState::failed);
  EXPECT_EQ(motion.roll_angle, Angle{});
  EXPECT_EQ(motion.roll_rate_rad_s, 0.0F);
  EXPECT_EQ(motion.specific_force_m_s2.x, 0.0F);
  EXPECT_EQ(motion.height_m, 0.0F);
  EXPECT_EQ(motion.distance_along_guide_m, 0.0F);
  EXPECT_EQ(motion.speed_m_s, 0.0F);
  EXPECT_EQ(motion.vertical_speed_m_s, 0.0F);
  EXPECT_NEAR(motion.tilt.radians(), 0.0F, 1e-7F) << "upright until the pad says otherwise";
  EXPECT_FALSE(motion.rate_is_lower_bound);
  EXPECT_FALSE(motion.roll_is_bridged);
  EXPECT_FALSE(motion.speed_is_lower_bound);
  EXPECT_EQ(motion.at_rest_for, Microseconds{0});
  EXPECT_EQ(gyros.estimator.gyro_vote(), GyroVote::neither);
}

Inputs on_the_pad(Microseconds measured, float roll_rate_rad_s, float across_m_s2) {
  Inputs inputs;
  inputs.time = measured;
  inputs.gyro = {.time = measured, .rate_rad_s = {roll_rate_rad_s, 0.0F, 0.0F}, .quality = SampleQuality::valid};
  inputs.accelerometers.fill(
      {.time = measured, .specific_force_m_s2 = {0.0F, across_m_s2, 0.0F}, .quality = SampleQuality::valid});
  return inputs;
}

TEST(MotionOnThePad, TheFirstBiasOfAllIsTheMeanOfTheFirstThreeSeconds) {
  MotionEstimator estimator{default_plan().motion};
  for (int t = 0; t <= 3'501; ++t) {
    estimator.update(on_the_pad(Microseconds{t * 1'000}, 0.015625F, standard_gravity_m_s2));
  }
  EXPECT_NEAR(estimator.motion(Microseconds{3'501'000}).roll_rate_rad_s, 0.0F, 1e-7F);
}

// As in PadWindow.AStepOfTheForceIsMotionWhenItsSquareHasComeThroughALowPassOf16Hertz. The step of a second is of a
// hundred time constants.
TEST(MotionOnThePad, AStepOfTheForceIsMotionWhenItsSquareHasComeThroughALowPassOf16Hertz) {
  MotionPlan plan = default_plan().motion;
  plan.rest_tolerance_m_s2 = 0.1F * standard_gravity_m_s2;
  for (const Microseconds step : {Microseconds{1'770}, Microseconds{1'880}, Microseconds{1'000'000}}) {
    MotionEstimator estimator{plan};
    estimator.update(on_the_pad(Microseconds{0}, 0.0F, standard_gravity_m_s2));
    estimator.update(on_the_pad(step, 0.0F, 1.5F * standard_gravity_m_s2));
    const bool rests = estimator.motion(step + Microseconds{1}).at_rest_for > Microseconds{0};
    EXPECT_EQ(rests, step < Microseconds{1'820}) << step.count();
  }
}

TEST(MotionOnThePad, InNoTimeNoForceComesThroughTheLowPass) {
  MotionEstimator estimator{default_plan().motion};
  Inputs inputs = on_the_pad(Microseconds{500}, 0.0F, standard_gravity_m_s2);
  inputs.time = Microseconds{1'000};
  estimator.update(inputs);
  estimator.update(on_the_pad(Microseconds{1'000}, 0.0F, 3.0F * standard_gravity_m_s2));
  EXPECT_EQ(estimator.motion(Microseconds{2'000}).at_rest_for, Microseconds{1'000});
}

Microseconds us(int value) { return Microseconds{value}; }

constexpr SampleQuality valid = SampleQuality::valid;

/// A rocket in free flight, upright at first, of which nothing is known but what its gyro says.
class Free {
 public:
  Free() {
    estimator.begin_flight(us(0));
    estimator.leave_guide();
  }
  void tick(int now_us, const Vector3& rate_rad_s) { estimator.update(inputs(now_us, rate_rad_s, valid, now_us)); }
  Motion bridge(int now_us, const Vector3& rate_rad_s, SampleQuality quality, int measured_us) {
    estimator.bridge(inputs(now_us, rate_rad_s, quality, measured_us));
    return estimator.motion(us(now_us));
  }
  Motion bridge(int now_us, const Vector3& rate_rad_s) { return bridge(now_us, rate_rad_s, valid, now_us); }

  MotionEstimator estimator{default_plan().motion};

 private:
  static Inputs inputs(int now_us, const Vector3& rate_rad_s, SampleQuality quality, int measured_us) {
    Inputs result;
    result.time = us(now_us);
    result.gyro = {.time = us(measured_us), .rate_rad_s = rate_rad_s, .quality = quality};
    return result;
  }
};

TEST(MotionBridge, TheRateGoesEvenlyFromTheLastSampleToTheNextAboutEachAxis) {
  for (const auto axis : {&Vector3::x, &Vector3::y, &Vector3::z}) {
    Free rocket;
    Vector3 rate;
    rate.*axis = 10.0F;
    rocket.tick(0, rate);
    rate.*axis = 30.0F;
    const Motion motion = rocket.bridge(50'000, rate);
    const float turned_rad = 0.05F * 0.5F * (10.0F + 30.0F);
    EXPECT_NEAR(motion.roll_angle.radians(), axis == &Vector3::x ? turned_rad : 0.0F, 1e-6F);
    EXPECT_NEAR(motion.tilt.radians(), axis == &Vector3::x ? 0.0F : turned_rad, 1e-5F);
    EXPECT_EQ(motion.roll_rate_rad_s, rate.x);
    EXPECT_TRUE(motion.roll_is_bridged);
  }
}

// One tick more than whole milliseconds fit in. The rates do not lie in one plane with the attitude: fewer or more
// steps would end somewhere else.
TEST(MotionBridge, MakesAsManyStepsAsThereWouldHaveBeenTicks) {
  const Vector3 first{64.0F, 0.0F, 0.0F};
  const Vector3 last{0.0F, 32.0F, 64.0F};
  struct Case {
    int gap_us;
    int ticks;
  };
  for (const auto& [gap_us, ticks] : {Case{999, 1}, Case{1'000, 2}, Case{1'998, 2}, Case{3'000, 4}}) {
    Free ticked;
    Free bridged;
    ticked.tick(0, first);
    bridged.tick(0, first);
    for (int i = 1; i <= ticks; ++i) {
      const float share = static_cast<float>(i) / static_cast<float>(ticks);
      ticked.tick(i * gap_us / ticks, {64.0F - share * 64.0F, share * 32.0F, share * 64.0F});
    }
    const Motion expected = ticked.estimator.motion(us(gap_us));
    const Motion motion = bridged.bridge(gap_us, last);
    EXPECT_FLOAT_EQ(motion.tilt.radians(), expected.tilt.radians()) << gap_us;
    EXPECT_FLOAT_EQ(motion.roll_angle.radians(), expected.roll_angle.radians()) << gap_us;
  }
}

TEST(MotionBridge, IsNoLongerThanASecond) {
  for (const int gap_us : {1'000'000, 1'000'001, 3'000'000}) {
    Free rocket;
    rocket.tick(0, {1.0F, 0.0F, 0.0F});
    EXPECT_NEAR(rocket.bridge(gap_us, {1.0F, 0.0F, 0.0F}).roll_angle.radians(), 1.0F, 3e-7F) << gap_us;
  }
}

TEST(MotionBridge, ReachesToTheTimeOfTheSampleAndItsRateGoesOnFromThere) {
  Free rocket;
  rocket.tick(0, {1.0F, 0.0F, 0.0F});
  const Motion motion = rocket.bridge(12'000, {3.0F, 0.0F, 0.0F}, valid, 10'000);
  EXPECT_NEAR(motion.roll_angle.radians(), 0.010F * 2.0F + 0.002F * 3.0F, 1e-7F);
}

TEST(MotionBridge, OverASampleThatCannotBeUsedOrWasSeenBeforeTheRateIsTakenToHaveStayed) {
  struct Case {
    SampleQuality quality;
    int measured_us;
  };
  // Absent; the one of before once more; an older one that is young enough to be current.
  for (const auto& [quality, measured_us] :
       {Case{SampleQuality::absent, 4'000}, Case{valid, 2'000}, Case{valid, 1'000}}) {
    Free rocket;
    rocket.tick(0, {2.0F, 0.0F, 0.0F});
    rocket.tick(2'000, {2.0F, 0.0F, 0.0F});
    const Motion motion = rocket.bridge(5'000, {9.0F, 0.0F, 0.0F}, quality, measured_us);
    EXPECT_NEAR(motion.roll_angle.radians(), 0.005F * 2.0F, 1e-8F) << measured_us;
    EXPECT_EQ(motion.roll_rate_rad_s, 2.0F) << measured_us;
    EXPECT_TRUE(motion.roll_is_bridged) << measured_us;
  }
}

TEST(MotionBridge, NoTimeAndAClockThatRanBackwardsTurnNothing) {
  for (const int now_us : {4'000, 3'000}) {
    Free rocket;
    rocket.tick(0, {64.0F, 0.0F, 0.0F});
    rocket.tick(4'000, {64.0F, 0.0F, 0.0F});
    const float before = rocket.estimator.motion(us(4'000)).roll_angle.radians();
    EXPECT_EQ(rocket.bridge(now_us, {}, SampleQuality::absent, now_us).roll_angle.radians(), before) << now_us;
  }
}

TEST(MotionBridge, ARocketThatStoodBeforeItHasNotStoodForATenthOfASecond) {
  MotionEstimator estimator{default_plan().motion};
  estimator.begin_flight(us(0));
  Inputs inputs;
  const auto stand = [&](int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      inputs.time += us(1'000);
      inputs.gyro = {.time = inputs.time, .rate_rad_s = {}, .quality = valid};
      inputs.accelerometers.fill({inputs.time, {standard_gravity_m_s2, 0.0F, 0.0F}, valid});
      estimator.update(inputs);
    }
  };
  stand(60);
  estimator.bridge(inputs);
  stand(100);
  EXPECT_EQ(estimator.motion(inputs.time).thrust_since, us(0));
  stand(1);
  EXPECT_EQ(estimator.motion(inputs.time).thrust_since, inputs.time);
}

}  // namespace

}  // namespace fantail::core
