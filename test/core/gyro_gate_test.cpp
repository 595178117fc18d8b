// SPDX-License-Identifier: MIT
#include "core/gyro_gate.hpp"

#include "core/flight_plan_fields.hpp"
#include "milliseconds.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

MotionPlan waits_for_100_ms() {
  MotionPlan plan = default_plan().motion;
  plan.longest_gyro_gap = ms(100);
  return plan;
}

/// A gate that has believed a sample of this rate at time zero.
class Gate {
 public:
  explicit Gate(float rate_rad_s = 1.0F) { at(0, rate_rad_s); }

  SensorState at(int time_ms, float rate_rad_s, SampleQuality quality = SampleQuality::valid, int measured_ms = -1) {
    return at(time_ms, Vector3{rate_rad_s, 0.0F, 0.0F}, quality, measured_ms);
  }
  SensorState at(int time_ms, const Vector3& rate_rad_s, SampleQuality quality = SampleQuality::valid,
                 int measured_ms = -1) {
    const GyroSample sample{
        .time = ms(measured_ms < 0 ? time_ms : measured_ms), .rate_rad_s = rate_rad_s, .quality = quality};
    const SensorState state = gate_.update(ms(time_ms), sample, flies, last_rate_rad_s_);
    last_rate_rad_s_ = state == SensorState::fresh ? rate_rad_s.x : last_rate_rad_s_;
    return state;
  }
  /// The fifth of five samples, one a millisecond, is the first that is believed.
  void expect_five_are_asked_for(int first_ms, const Vector3& rate_rad_s) {
    for (int i = 0; i < 5; ++i) {
      EXPECT_EQ(at(first_ms + i, rate_rad_s), i < 4 ? SensorState::lost : SensorState::fresh) << i;
    }
  }
  void skip_to(int time_ms) { gate_.skip_to(ms(time_ms)); }

  bool flies = true;

 private:
  GyroGate gate_{waits_for_100_ms()};
  float last_rate_rad_s_ = 0.0F;
};

TEST(GyroGate, ASilentGyroHasFailedAfterThePlansLongestGapInFlightAndAfterItsStaleTimeOnThePad) {
  for (const bool flies : {true, false}) {
    Gate gate;
    gate.flies = flies;
    const int patience_ms = flies ? 100 : 5;
    for (int t = 1; t <= 150; ++t) {
      EXPECT_EQ(gate.at(t, 0.0F, SampleQuality::absent), t <= patience_ms ? SensorState::lost : SensorState::failed)
          << t;
    }
  }
}

TEST(GyroGate, AGapThatIsNotStaleCostsNoWaiting) {
  Gate gate;
  EXPECT_EQ(gate.at(5, 1.0F), SensorState::fresh);
}

TEST(GyroGate, AfterASilenceTheFifthOfFiveSamplesThatAgreeIsBelieved) {
  for (const Vector3 rate : {Vector3{3.0F, 0.0F, 0.0F}, {0.0F, 3.0F, 0.0F}, {0.0F, 0.0F, 3.0F}}) {
    Gate gate;
    gate.expect_five_are_asked_for(50, rate);
    EXPECT_EQ(gate.at(55, rate), SensorState::fresh);
  }
}

TEST(GyroGate, EverySilenceIsFollowedByFiveSamplesThatAgree) {
  Gate gate;
  gate.expect_five_are_asked_for(50, {3.0F, 0.0F, 0.0F});
  gate.expect_five_are_asked_for(100, {3.0F, 0.0F, 0.0F});
}

TEST(GyroGate, AClockThatWasSetBackWhileNobodyWatchedDoesNotKeepTheGyroOutUntilItIsWhereItWas) {
  Gate gate;
  gate.expect_five_are_asked_for(50, {3.0F, 0.0F, 0.0F});
  gate.skip_to(10);
  gate.expect_five_are_asked_for(30, {3.0F, 0.0F, 0.0F});
}

TEST(GyroGate, AfterASilenceSamplesThatDoNotAgreeAreNotBelieved) {
  Gate gate;
  for (int t = 50; t < 100; ++t) {
    EXPECT_EQ(gate.at(t, t % 4 == 0 ? 3.0F : 5.0F), SensorState::lost) << "three in a row at most";
  }
}

TEST(GyroGate, ASampleThatIsRepeatedDoesNotAgreeWithItself) {
  Gate gate;
  for (int t = 50; t < 55; ++t) {
    EXPECT_EQ(gate.at(t, 3.0F, SampleQuality::valid, 50), SensorState::lost);
  }
  // It counts as one of five.
  for (int t = 55; t < 59; ++t) {
    EXPECT_EQ(gate.at(t, 3.0F), t < 58 ? SensorState::lost : SensorState::fresh) << t;
  }
}

TEST(GyroGate, TheEndOfTheRangeIsBelievedOfARateThatWasOnItsWayThereAndNotOfAJump) {
  for (const float sense : {1.0F, -1.0F}) {
    EXPECT_EQ(Gate{sense * 30.0F}.at(1, sense * 34.9F, SampleQuality::saturated), SensorState::fresh);
    EXPECT_EQ(Gate{sense * 20.0F}.at(1, sense * 34.9F, SampleQuality::saturated), SensorState::lost);
    EXPECT_EQ(Gate{sense * -30.0F}.at(1, sense * 34.9F, SampleQuality::saturated), SensorState::lost);
  }
}

TEST(GyroGate, OfTheEndOfTheRangeThreeQuartersAreOnTheWayThere) {
  // 24 of 32 are exactly three quarters; the other one is the next smaller float.
  EXPECT_EQ(Gate{24.0F}.at(1, 32.0F, SampleQuality::saturated), SensorState::fresh);
  EXPECT_EQ(Gate{std::nextafter(24.0F, 0.0F)}.at(1, 32.0F, SampleQuality::saturated), SensorState::lost);
}

TEST(GyroGate, OnThePadAGyroThatComesBackIsBelievedAtOnce) {
  Gate gate;
  gate.flies = false;
  EXPECT_EQ(gate.at(1'000, 3.0F), SensorState::fresh);
}

}  // namespace
}  // namespace fantail::core
