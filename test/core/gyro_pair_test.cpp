// SPDX-License-Identifier: MIT
#include "core/gyro_pair.hpp"

#include "core/flight_plan_fields.hpp"
#include "milliseconds.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

// In rad/s, as all rates here; 5 % of the rate comes on top.
constexpr float limit = 0.2F;

FlightPlan two_gyros() {
  FlightPlan plan = default_plan();
  plan.sensors.gyros = GyroRule::two_agree;
  plan.sensors.gyro_disagreement_rad_s = limit;
  return plan;
}

/// Two gyros that are read once a millisecond, and whoever follows what is chosen. Their noise is a count of 0.001.
class Pair {
 public:
  struct Reading {
    float rate_rad_s;
    SampleQuality quality = SampleQuality::valid;
    int age_ms = 0;
    bool frozen = false;
  };

  GyroSample tick(const Reading& first, const std::optional<Reading>& second) {
    time_ += ms(1);
    noise_ = -noise_;
    Inputs inputs{.time = time_, .gyro = sample(first)};
    if (second) {
      inputs.second_gyro = sample(*second);
    }
    const GyroSample chosen = pair_.choose(inputs, flies, {last_rad_s_, 0.0F, 0.0F}, gate_);
    state = gate_.update(time_, chosen, flies, last_rad_s_);
    last_rad_s_ = state == SensorState::fresh ? chosen.rate_rad_s.x : last_rad_s_;
    return chosen;
  }
  /// The vote of the last tick.
  GyroVote run(int ticks, const Reading& first, const std::optional<Reading>& second) {
    for (int i = 0; i < ticks; ++i) {
      tick(first, second);
    }
    return pair_.vote();
  }
  [[nodiscard]] GyroVote vote() const { return pair_.vote(); }

  bool flies = true;
  SensorState state = SensorState::failed;
  float Vector3::* noisy_axis = &Vector3::x;

 private:
  [[nodiscard]] GyroSample sample(const Reading& reading) const {
    GyroSample result{
        .time = time_ - ms(reading.age_ms), .rate_rad_s = {reading.rate_rad_s, 0.0F, 0.0F}, .quality = reading.quality};
    if (!reading.frozen) {
      result.rate_rad_s.*noisy_axis += noise_;
    }
    return result;
  }

  FlightPlan plan_ = two_gyros();
  GyroPair pair_{plan_.sensors, plan_.motion};
  GyroGate gate_{plan_.motion};
  Microseconds time_{};
  float noise_ = 0.001F;
  float last_rad_s_ = 0.0F;
};

constexpr float noise = 0.0011F;

TEST(GyroPair, OfTwoThatAgreeTheFirstIsUsed) {
  Pair pair;
  const GyroSample chosen = pair.tick({1.0F}, Pair::Reading{1.1F});
  EXPECT_NEAR(chosen.rate_rad_s.x, 1.0F, noise);
  EXPECT_EQ(pair.vote(), GyroVote::both);
  EXPECT_EQ(pair.state, SensorState::fresh);
}

TEST(GyroPair, TheOtherIsUsedInTheSameTickInWhichOneSaysNothing) {
  for (const SampleQuality silent : {SampleQuality::absent, SampleQuality::invalid}) {
    Pair pair;
    pair.run(10, {1.0F}, Pair::Reading{1.0F});
    EXPECT_NEAR(pair.tick({7.0F, silent}, Pair::Reading{1.1F}).rate_rad_s.x, 1.1F, noise);
    EXPECT_EQ(pair.vote(), GyroVote::second);
    EXPECT_EQ(pair.state, SensorState::fresh);
  }
  Pair pair;
  EXPECT_EQ(pair.run(10, {1.0F}, Pair::Reading{1.0F, SampleQuality::absent}), GyroVote::first);
  EXPECT_EQ(pair.run(10, {1.0F}, std::nullopt), GyroVote::first) << "not fitted";
  EXPECT_EQ(pair.state, SensorState::fresh);
}

TEST(GyroPair, OneThatHangsIsLeftBeforeItsSampleIsStale) {
  Pair pair;
  pair.run(10, {1.0F}, Pair::Reading{1.0F});
  for (int age = 1; age <= 20; ++age) {
    pair.tick({1.0F, SampleQuality::valid, age, true}, Pair::Reading{1.0F});
    EXPECT_TRUE(pair.state == SensorState::fresh || pair.state == SensorState::coasting) << age;
    EXPECT_EQ(pair.vote(), age < 3 ? GyroVote::both : GyroVote::second) << age << ": 2.5 ms are half the stale time";
  }
}

TEST(GyroPair, ToChangeToSamplesThatAreOlderIsNoGap) {
  Pair pair;
  pair.run(10, {1.0F}, Pair::Reading{1.0F, SampleQuality::valid, 2});
  for (int i = 0; i < 10; ++i) {
    pair.tick({1.0F, SampleQuality::absent}, Pair::Reading{1.0F, SampleQuality::valid, 2});
    EXPECT_EQ(pair.state, i < 2 ? SensorState::coasting : SensorState::fresh) << i;
  }
}

TEST(GyroPair, OneThatRepeatsItselfWhileTheOtherTurnsIsPutAside) {
  Pair pair;
  pair.run(10, {1.0F}, Pair::Reading{1.0F});
  for (int i = 0; i < 30; ++i) {
    const float turning = 1.0F + 0.01F * static_cast<float>(i);
    pair.tick({1.0F, SampleQuality::valid, 0, true}, Pair::Reading{turning});
    EXPECT_EQ(pair.vote(), i < 9 ? GyroVote::both : GyroVote::second) << i;
  }
}

TEST(GyroPair, TheSecondIsPutAsideLikewise) {
  Pair pair;
  pair.run(10, {1.0F}, Pair::Reading{1.0F});
  for (int i = 0; i < 30; ++i) {
    const float turning = 1.0F + 0.01F * static_cast<float>(i);
    pair.tick({turning}, Pair::Reading{1.0F, SampleQuality::valid, 0, true});
    EXPECT_EQ(pair.vote(), i < 9 ? GyroVote::both : GyroVote::first) << i;
  }
}

TEST(GyroPair, OneWhoseNoiseIsSeenAboutASingleAxisDoesNotRepeatItself) {
  for (float Vector3::* const axis : {&Vector3::x, &Vector3::y, &Vector3::z}) {
    Pair pair;
    pair.noisy_axis = axis;
    pair.run(10, {1.0F}, Pair::Reading{1.0F});
    // The first stays where it was, up to its noise, and the other turns away from it by half of what is allowed.
    EXPECT_EQ(pair.run(15, {1.0F}, Pair::Reading{1.1F}), GyroVote::both);
  }
}

TEST(GyroPair, OneThatGoesOnRepeatingItselfIsNotBelievedAgainWhereTheOtherComesBy) {
  Pair pair;
  pair.run(10, {1.0F}, Pair::Reading{1.0F});
  const Pair::Reading frozen{1.0F, SampleQuality::valid, 0, true};
  EXPECT_EQ(pair.run(20, frozen, Pair::Reading{1.1F}), GyroVote::second);
  EXPECT_EQ(pair.run(500, frozen, Pair::Reading{1.0F}), GyroVote::second);
  EXPECT_EQ(pair.run(30, {1.0F}, Pair::Reading{1.0F}), GyroVote::both);
}

TEST(GyroPair, OneThatRepeatsItselfAtRestIsBelieved) {
  Pair pair;
  EXPECT_EQ(pair.run(1'000, {0.01F, SampleQuality::valid, 0, true}, Pair::Reading{0.02F}), GyroVote::both);
}

TEST(GyroPair, TwoThatRepeatThemselvesAndDifferDisagree) {
  Pair pair;
  EXPECT_EQ(pair.run(100, {0.0F, SampleQuality::valid, 0, true}, Pair::Reading{0.5F, SampleQuality::valid, 0, true}),
            GyroVote::disagree);
}

TEST(GyroPair, TwoThatRepeatThemselvesStandStill) {
  Pair pair;
  EXPECT_EQ(pair.run(100, {0.0F, SampleQuality::valid, 0, true}, Pair::Reading{0.0F, SampleQuality::valid, 0, true}),
            GyroVote::both);
}

TEST(GyroPair, OneThatJumpsToTheEndOfItsRangeIsPutAside) {
  Pair pair;
  pair.run(10, {1.0F}, Pair::Reading{1.0F});
  EXPECT_NEAR(pair.tick({34.9F, SampleQuality::saturated}, Pair::Reading{1.0F}).rate_rad_s.x, 1.0F, noise);
  EXPECT_EQ(pair.vote(), GyroVote::second);
}

TEST(GyroPair, WhereOneHasComeToTheEndOfItsRangeTheOtherGoesOnMeasuring) {
  for (const float sense : {1.0F, -1.0F}) {
    Pair pair;
    for (int rate = 1; rate <= 34; ++rate) {
      pair.tick({sense * static_cast<float>(rate)}, Pair::Reading{sense * static_cast<float>(rate)});
    }
    const GyroSample chosen = pair.tick({sense * 34.9F, SampleQuality::saturated}, Pair::Reading{sense * 50.0F});
    EXPECT_NEAR(chosen.rate_rad_s.x, sense * 50.0F, noise);
    EXPECT_EQ(chosen.quality, SampleQuality::valid);
    EXPECT_EQ(pair.vote(), GyroVote::both);
  }
}

TEST(GyroPair, OfTwoAtTheEndOfTheirRangeTheFirstIsUsedAndOneThatMeasuresBeforeIt) {
  for (const auto second : {SampleQuality::saturated, SampleQuality::valid}) {
    Pair pair;
    for (int rate = 1; rate <= 34; ++rate) {
      pair.tick({static_cast<float>(rate)}, Pair::Reading{static_cast<float>(rate)});
    }
    const GyroSample chosen = pair.tick({34.9F, SampleQuality::saturated}, Pair::Reading{34.95F, second});
    EXPECT_EQ(chosen.quality, second);
    EXPECT_NEAR(chosen.rate_rad_s.x, second == SampleQuality::valid ? 34.95F : 34.9F, noise);
  }
}

TEST(GyroPair, ASpikeInEitherCostsNothing) {
  for (const bool in_first : {true, false}) {
    Pair pair;
    pair.run(10, {1.0F}, Pair::Reading{1.0F});
    const float a = in_first ? 20.0F : 1.0F;
    const float b = in_first ? 1.0F : -20.0F;
    EXPECT_NEAR(pair.tick({a}, Pair::Reading{b}).rate_rad_s.x, 1.0F, noise);
    EXPECT_EQ(pair.vote(), in_first ? GyroVote::second : GyroVote::first);
    EXPECT_EQ(pair.run(1, {1.0F}, Pair::Reading{1.0F}), GyroVote::both);
  }
}

TEST(GyroPair, TwoThatDifferForTwentyMillisecondsAreBothLeftAndBelievedWhenTheyHaveAgreedForAsLong) {
  Pair pair;
  pair.run(10, {1.0F}, Pair::Reading{1.0F});
  // 0.2 and 5 % of 1.3.
  EXPECT_EQ(pair.run(100, {1.0F}, Pair::Reading{1.26F}), GyroVote::both);
  for (int i = 0; i < 100; ++i) {
    pair.tick({1.0F}, Pair::Reading{1.3F});
    EXPECT_EQ(pair.vote(), i < 20 ? GyroVote::first : GyroVote::disagree) << i;
    EXPECT_EQ(pair.state, i < 20 ? SensorState::fresh : SensorState::lost) << i;
  }
  for (int i = 0; i < 30; ++i) {
    pair.tick({1.0F}, Pair::Reading{1.1F});
    EXPECT_EQ(pair.vote(), i < 20 ? GyroVote::disagree : GyroVote::both) << i;
    EXPECT_EQ(pair.state, i < 24 ? SensorState::lost : SensorState::fresh) << i << ": the fifth sample that agrees";
  }
}

TEST(GyroPair, ADisagreementIsOverWhenOneOfTheTwoFallsSilent) {
  Pair pair;
  EXPECT_EQ(pair.run(50, {1.0F}, Pair::Reading{3.0F}), GyroVote::disagree);
  EXPECT_EQ(pair.run(1, {1.0F}, Pair::Reading{3.0F, SampleQuality::invalid}), GyroVote::first);
}

TEST(GyroPair, OneThatComesBackWithSomethingElseDoesNotEndTheFlightOfTheOther) {
  Pair pair;
  pair.run(10, {1.0F}, Pair::Reading{1.0F});
  pair.run(46, {1.0F, SampleQuality::absent}, Pair::Reading{1.0F});
  EXPECT_EQ(pair.run(500, {9.0F}, Pair::Reading{1.0F}), GyroVote::second);
  EXPECT_EQ(pair.state, SensorState::fresh);
  EXPECT_EQ(pair.run(20, {1.0F}, Pair::Reading{1.0F}), GyroVote::second);
  EXPECT_EQ(pair.run(1, {1.0F}, Pair::Reading{1.0F}), GyroVote::both);
}

TEST(GyroPair, WithoutAnyItSaysNothing) {
  Pair pair;
  pair.run(10, {1.0F}, Pair::Reading{1.0F});
  const GyroSample chosen = pair.tick({1.0F, SampleQuality::absent}, std::nullopt);
  EXPECT_EQ(chosen.quality, SampleQuality::absent);
  EXPECT_EQ(pair.vote(), GyroVote::neither);
  EXPECT_EQ(pair.state, SensorState::lost);
}

TEST(GyroPair, ToChangeFromOneToTheOtherStepsTheRateByNothingThatWasThereOnThePad) {
  Pair pair;
  pair.flies = false;
  pair.run(4'000, {0.01F}, Pair::Reading{0.16F});
  pair.flies = true;
  pair.run(100, {2.01F}, Pair::Reading{2.16F});
  EXPECT_NEAR(pair.tick({2.01F, SampleQuality::absent}, Pair::Reading{2.16F}).rate_rad_s.x, 2.01F, 2.0F * noise);
}

TEST(GyroPair, WhatTheyDifferByOnThePadDoesNotWidenWhatIsAllowed) {
  Pair pair;
  pair.flies = false;
  for (int i = 0; i < 20'000; ++i) {  // drifts away by 1 rad/s in 20 s
    pair.tick({0.0F}, Pair::Reading{5e-5F * static_cast<float>(i)});
  }
  EXPECT_EQ(pair.vote(), GyroVote::disagree);
}

}  // namespace
}  // namespace fantail::core
