// SPDX-License-Identifier: MIT

#include "core/flight_plan_fields.hpp"
#include "core/gyro_pair.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

Microseconds us(int value) { return Microseconds{value}; }

// In rad/s, as all rates here; 5 % of the rate comes on top.
constexpr float allowed = 0.25F;
constexpr std::array axes{&Vector3::x, &Vector3::y, &Vector3::z};

FlightPlan two_gyros() {
  FlightPlan plan = default_plan();
  plan.sensors.gyros = GyroRule::two_agree;
  plan.sensors.gyro_disagreement_rad_s = allowed;
  plan.motion.stale_time = us(5'000);
  return plan;
}

Vector3 about(float Vector3::* axis, float rate_rad_s) {
  Vector3 result;
  result.*axis = rate_rad_s;
  return result;
}

/// Two gyros of which every bit is given, after a last rate that is given too.
class Pair {
 public:
  struct Reading {
    Vector3 rate_rad_s;
    SampleQuality quality = SampleQuality::valid;
    Microseconds age{};
  };

  GyroSample tick(const Reading& first, const Reading& second, Microseconds step = us(1'000)) {
    time_ += step;
    const Inputs inputs{.time = time_, .gyro = sample(first), .second_gyro = sample(second)};
    return pair_.choose(inputs, flies, {last_rad_s, 0.0F, 0.0F}, gate_);
  }
  GyroSample tick(float first_rad_s, float second_rad_s, Microseconds step = us(1'000)) {
    return tick({{first_rad_s, 0.0F, 0.0F}}, {{second_rad_s, 0.0F, 0.0F}}, step);
  }
  [[nodiscard]] GyroVote vote() const { return pair_.vote(); }

  bool flies = true;
  float last_rad_s = 0.0F;

 private:
  [[nodiscard]] GyroSample sample(const Reading& reading) const {
    return {.time = time_ - reading.age, .rate_rad_s = reading.rate_rad_s, .quality = reading.quality};
  }

  FlightPlan plan_ = two_gyros();
  GyroPair pair_{plan_.sensors, plan_.motion};
  GyroGate gate_{plan_.motion};
  Microseconds time_{};
};

TEST(GyroPair, OneThatRepeatsItselfIsPutAsideWhenTheOtherIsMoreThanAnEighthOfWhatIsAllowedAway) {
  // An eighth is 0.03125, and 0.0002 for the rate.
  for (const float away : {0.031F, 0.032F}) {
    Pair pair;
    for (int i = 0; i < 30; ++i) {
      pair.tick(0.0F, i % 2 == 0 ? away : away - 0.0001F);
    }
    EXPECT_EQ(pair.vote(), away < 0.0315F ? GyroVote::both : GyroVote::second) << away;
  }
}

TEST(GyroPair, OneThatRepeatsItselfIsBelievedWhileTheOtherRepeatsItselfToo) {
  for (const bool is_first : {true, false}) {
    Pair pair;
    const auto tick = [&](float other) { is_first ? pair.tick(1.0F, other) : pair.tick(other, 1.0F); };
    for (int i = 0; i < 9; ++i) {
      tick(i % 2 == 0 ? 1.1F : 1.11F);
    }
    tick(1.1F);  // the tenth of the same, and the second of the same
    EXPECT_EQ(pair.vote(), GyroVote::both);
    tick(1.11F);
    EXPECT_EQ(pair.vote(), is_first ? GyroVote::second : GyroVote::first);
  }
}

TEST(GyroPair, ASampleThatIsReadTwiceIsNoneThatRepeatsItself) {
  Pair pair;
  for (int i = 0; i < 18; ++i) {  // nine samples of the first, each read twice, say the same
    const Pair::Reading first{.rate_rad_s = about(&Vector3::x, 1.0F), .age = us(i % 2 * 1'000)};
    pair.tick(first, {about(&Vector3::x, i % 2 == 0 ? 1.1F : 1.11F)});
    EXPECT_EQ(pair.vote(), GyroVote::both) << i;
  }
}

TEST(GyroPair, OneThatIsOlderThanTheOtherByHalfTheStaleTimeIsBelievedAndOlderOneIsNot) {
  Pair pair;
  const Pair::Reading young{about(&Vector3::x, 1.0F)};
  Pair::Reading old = young;
  old.age = us(2'500);
  pair.tick(old, young);
  EXPECT_EQ(pair.vote(), GyroVote::both);
  pair.tick(young, old);
  EXPECT_EQ(pair.vote(), GyroVote::both);
  old.age = us(2'501);
  pair.tick(old, young);
  EXPECT_EQ(pair.vote(), GyroVote::second);
  pair.tick(young, old);
  EXPECT_EQ(pair.vote(), GyroVote::first);
}

TEST(GyroPair, ADisagreementOfTwentyMillisecondsToTheMicrosecondIsTooLong) {
  Pair pair;
  for (int i = 0; i < 20; ++i) {
    pair.tick(0.0F, 1.0F);
  }
  pair.tick(0.0F, 1.0F, us(999));  // 19 999 us after the first of them
  EXPECT_EQ(pair.vote(), GyroVote::first);
  pair.tick(0.0F, 1.0F, us(1));
  EXPECT_EQ(pair.vote(), GyroVote::disagree);
}

TEST(GyroPair, OfTwoThatDifferAndAreEquallyFarFromTheLastRateTheFirstIsUsed) {
  for (const float away : {0.5F, -0.5F}) {
    Pair pair;
    pair.last_rad_s = 1.0F;
    EXPECT_EQ(pair.tick(1.0F + away, 1.0F - away).rate_rad_s.x, 1.0F + away);
    EXPECT_EQ(pair.vote(), GyroVote::first);
  }
}

TEST(GyroPair, ASecondAtTheEndOfItsRangeAgreesWithAFirstThatMeasuresBeyondAndNotWithOneThatMeasuresFarLess) {
  for (const float sense : {1.0F, -1.0F}) {
    const Pair::Reading at_its_end{about(&Vector3::x, sense * 32.0F), SampleQuality::saturated};
    Pair pair;
    pair.last_rad_s = sense * 31.0F;
    EXPECT_EQ(pair.tick({about(&Vector3::x, sense * 50.0F)}, at_its_end).rate_rad_s.x, sense * 50.0F);
    EXPECT_EQ(pair.vote(), GyroVote::both);
    pair.tick({about(&Vector3::x, sense * 24.0F)}, at_its_end);
    EXPECT_NE(pair.vote(), GyroVote::both);
  }
}

// The second reads as the first would: less the mean of what it has read more than the first.
TEST(GyroPair, WhatIsTakenOffTheSecondIsTheMeanOfAllSamplesOnThePad) {
  constexpr std::array more{0.125F, 0.0F, 0.0625F, 0.1875F};
  constexpr std::array mean{0.125F, 0.0625F, 0.0625F, 0.09375F};
  for (const auto axis : axes) {
    for (std::size_t samples = 1; samples <= more.size(); ++samples) {
      Pair pair;
      pair.flies = false;
      for (std::size_t i = 0; i < samples; ++i) {
        pair.tick({about(axis, 0.25F)}, {about(axis, 0.25F + more[i])});
      }
      const Vector3 chosen = pair.tick({{}, SampleQuality::absent}, {about(axis, 0.5F)}).rate_rad_s;
      EXPECT_FLOAT_EQ(chosen.*axis, 0.5F - mean[samples - 1]) << samples;
    }
  }
}

TEST(GyroPair, AfterThreeThousandSamplesOfThePadEachNewOneIsAThreeThousandthOfTheMean) {
  Pair pair;
  pair.flies = false;
  for (int i = 0; i < 3'000; ++i) {
    const float both = i % 2 == 0 ? 0.0F : 0.25F;
    pair.tick(both, both);
  }
  for (int i = 1; i <= 2; ++i) {
    pair.tick(0.0F, 0.1875F);
  }
  const float of_the_second = pair.tick({{}, SampleQuality::absent}, {}).rate_rad_s.x;
  // d, and then d + (0.1875 - d) / 3000.
  EXPECT_FLOAT_EQ(of_the_second, -0.1875F * (2.0F - 1.0F / 3'000.0F) / 3'000.0F);
}

}  // namespace
}  // namespace fantail::core
