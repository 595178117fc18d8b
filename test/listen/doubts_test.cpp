// SPDX-License-Identifier: MIT
// What is said of columns that are not what they were said to be, and of how the log was flown.
#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "listen/fly_log.hpp"
#include "listen/made_log.hpp"
#include "listen/sentences.hpp"

namespace fantail::listen {
namespace {

using namespace made;

Heard with_second(const std::function<double(double)>& second, double disagreement_g = 0.5) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  log.second_axial = signal(20.0, 0.01, second);
  Question asked = question();
  asked.plan.launch_detection.disagreement_m_s2 = static_cast<float>(disagreement_g * g);
  return fly_log(std::move(log), asked);
}

// 1.85 g for 6 s is no lift-off by the rule; free fall, and then the shock of the parachute is.
double weak_push(double t) { return t < 5.0 ? g : t < 11.0 ? 1.85 * g : t < 18.0 ? 0.0 : t < 18.7 ? 5.0 * g : g; }

TEST(Doubts, OfALiftOffBehindAWeakPushAndAFallThatItIsTheParachute) {
  const Heard heard = fly_log(log_of(signal(30.0, 0.01, weak_push)), question());
  ASSERT_NEAR(heard.lift_off_s.value(), 18.0, 0.02);
  EXPECT_TRUE(doubts(heard, "From 4.99 s") &&
              doubts(heard, "before lift-off, the axial force is not between 0.5 and 1.5 g for more than 0.5 s"))
      << text_of(heard);
  // Bumps of a tenth of a second on the way to the guide are none.
  const auto bumped = [](double t) { return t > 2.0 && t < 2.1 ? 0.1 * g : constant_push(t); };
  EXPECT_FALSE(doubts(fly_log(log_of(signal(20.0, 0.01, bumped)), question()), "before lift-off"));
}

TEST(Doubts, OfNoLiftOffWhereTheHeightRisesThatThereIsNone) {
  ImuLog log = log_of(signal(12.0, 0.01, weak_push));
  log.height = signal(12.0, 0.05, [](double t) { return t < 5.0 ? 100.0 : 100.0 + 4.0 * (t - 5.0) * (t - 5.0); });
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_EQ(finding(heard), Finding::no_launch);
  EXPECT_TRUE(doubts(heard, "The log's own height rises by 196 m: was that a launch that pushed too weakly"))
      << text_of(heard);
}

TEST(Doubts, OfAHeightWithoutASampleInTheFlightItsClockAndNotItsUnit) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  log.height = signal(3.0, 0.05, [](double) { return 100.0; });
  for (double& time_s : log.height.time_s) {
    time_s += 1000.0;
  }
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_TRUE(doubts(heard, "has no sample in the 5 s after lift-off, and is left out: is it on the same clock"))
      << text_of(heard);
  EXPECT_EQ(heard.log_height.apogee_s, std::nullopt);
}

TEST(Doubts, OfASecondAccelerometerThatDoesNotReadOneGOnThePadAreThoseOfTheFirst) {
  const Heard in_g = with_second([](double t) { return constant_push(t) / g; });
  EXPECT_EQ(finding(in_g), Finding::missed);
  EXPECT_TRUE(doubts(in_g, "Before lift-off the second axial force reads 0.10 g in the mean")) << text_of(in_g);
  EXPECT_TRUE(doubts(in_g, "gravity seems not to be in it (second_axial_from_rest), or its unit is wrong"));
  EXPECT_FALSE(doubts(in_g, "the axial force reads")) << text_of(in_g);

  const Heard reversed = with_second([](double t) { return -constant_push(t); });
  EXPECT_TRUE(doubts(reversed, "the second axial force reads -1.00 g in the mean")) << text_of(reversed);
  EXPECT_TRUE(doubts(reversed, "its sign seems to be wrong"));
  const Heard half = with_second([](double t) { return 0.5 * constant_push(t); });
  EXPECT_TRUE(doubts(half, "the second axial force reads 0.50 g in the mean")) << text_of(half);
  EXPECT_TRUE(doubts(half, "is gravity in it (second_axial) or not (second_axial_from_rest)?"));
  EXPECT_TRUE(with_second(constant_push).doubts.empty());
}

// It reads 1 g on the pad, and under thrust 1 g too little, then 3 g.
TEST(Doubts, SayThatTheLawRefusedALaunchBecauseTheTwoAccelerometersDisagree) {
  const auto short_of = [](double by_g) {
    return [=](double t) { return constant_push(t) - (t >= 5.0 && t < 7.0 ? by_g * g : 0.0); };
  };
  const Heard refused = with_second(short_of(1.0));
  EXPECT_EQ(finding(refused), Finding::missed);
  EXPECT_TRUE(doubts(refused, "The two accelerometers differed by more than the plan's 0.5 g")) << text_of(refused);
  EXPECT_TRUE(doubts(refused, "in the second after lift-off")) << text_of(refused);
  EXPECT_NEAR(refused.no_hold.in_all_s, 0.99, 0.015);
  EXPECT_NEAR(refused.no_hold.first_s, 5.0, 0.02);
  EXPECT_NEAR(data_of(refused)["disagreed_before_detection_s"].number(), 0.99, 0.015);

  const Heard agreed = with_second(short_of(1.0), 2.0);
  EXPECT_EQ(finding(agreed), Finding::heard);
  EXPECT_TRUE(agreed.doubts.empty()) << agreed.doubts[0];
  EXPECT_FALSE(says(agreed, "differed"));
  EXPECT_EQ(agreed.no_hold.in_all_s, 0.0);
}

// They differ on the pad already, which was before.
TEST(Doubts, OfADisagreementCountOnlyTheSecondAfterLiftOff) {
  const Heard reversed = with_second([](double t) { return -constant_push(t); });
  EXPECT_TRUE(doubts(reversed, "for 1000 ms in the second after lift-off (there first at 4.993 s"))
      << text_of(reversed);
}

TEST(Doubts, DoNotCountADisagreementThatTheLaunchWasHeardThrough) {
  const Heard shaken = with_second([](double t) { return constant_push(t) - (t >= 5.0 && t < 5.1 ? g : 0.0); });
  EXPECT_EQ(finding(shaken), Finding::heard);
  EXPECT_TRUE(shaken.doubts.empty()) << shaken.doubts[0];
  EXPECT_TRUE(says(shaken, "The two accelerometers differed by more than the plan's 0.5 g")) << text_of(shaken);
  EXPECT_TRUE(says(shaken, "between lift-off and the detection")) << text_of(shaken);
}

// They agree for as long as the hold takes, and from then on differ by a g.
TEST(Doubts, SayThatTheLawHeldControlBackBecauseTheTwoAccelerometersDisagree) {
  const Heard held = with_second([](double t) { return constant_push(t) - (t >= 5.2 && t < 7.0 ? g : 0.0); });
  EXPECT_TRUE(held.detected_s);
  EXPECT_FALSE(held.control);
  EXPECT_TRUE(doubts(held, "beyond its guide, or then, so that it began no control for")) << text_of(held);
  EXPECT_GT(held.no_control.in_all_s, 0.5);
}

// 100 gaps of half a second under the parachute, one of them before apogee.
TEST(Notes, CountTheGapsUpToApogeeAndThoseBehindIt) {
  ImuLog log = log_of(signal(70.0, 0.01, constant_push));
  log.height = signal(70.0, 0.1, [](double t) {
    return t < 5.0 ? 0.0 : t < 15.0 ? 392.0 - 3.92 * (15.0 - t) * (15.0 - t) : 392.0 - 5.0 * (t - 15.0);
  });
  const auto is_lost = [](double t) { return (t > 10.005 && t < 10.495) || (t > 20.0 && std::fmod(t, 1.0) > 0.505); };
  std::erase_if(log.axial.value, [&, i = std::size_t{0}](double) mutable { return is_lost(log.axial.time_s[i++]); });
  std::erase_if(log.axial.time_s, is_lost);
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_GT(heard.gaps.size(), 40U);
  EXPECT_TRUE(says(heard, fmt::format("{} gaps of the log are longer than the 100 ms", heard.gaps.size())))
      << text_of(heard);
  EXPECT_TRUE(says(heard, "1 begins before apogee")) << text_of(heard);
  EXPECT_TRUE(says(heard, "The longest of these is from 10.000 s to 10.500 s")) << text_of(heard);
}

TEST(Notes, OfGapsThatAreAllBehindApogeeSaySo) {
  ImuLog log = log_of(signal(70.0, 0.01, constant_push));
  const auto is_lost = [](double t) { return t > 30.0 && std::fmod(t, 1.0) > 0.505; };
  std::erase_if(log.axial.value, [&, i = std::size_t{0}](double) mutable { return is_lost(log.axial.time_s[i++]); });
  std::erase_if(log.axial.time_s, is_lost);
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_TRUE(says(heard, "none begins before apogee")) << text_of(heard);
  EXPECT_FALSE(says(heard, "old samples")) << text_of(heard);
}

TEST(Notes, OfALogFasterThanTheLawSayThatOnlyWhatFallsOnItsTicksIsUsed) {
  const auto flown = [](double interval_s) {
    return fly_log(log_of(signal(10.0, interval_s, constant_push), interval_s), question());
  };
  const Heard fast = flown(0.0005);
  EXPECT_TRUE(says(fast, "2000 samples a second")) << text_of(fast);
  EXPECT_TRUE(says(fast, "the log is faster than that")) << text_of(fast);
  EXPECT_FALSE(says(fast, "faster motion than the log's")) << text_of(fast);
  EXPECT_TRUE(says(flown(0.001), "faster motion than the log's is not in it"));
}

TEST(Doubts, OfALogWithAQuarterOfASecondBetweenSamplesAreThereFromExactlyThatOn) {
  const auto flown = [](double interval_s) {
    return fly_log(log_of(signal(20.0, interval_s, constant_push), interval_s), question());
  };
  EXPECT_TRUE(doubts(flown(0.25), "A quarter of a second and more"));
  EXPECT_TRUE(doubts(flown(0.3), "A quarter of a second and more"));
  EXPECT_FALSE(doubts(flown(0.24), "A quarter of a second and more"));
}

// Of the closed form, 40 g m at 15 s, with another unit.
Heard with_height(double scale) {
  ImuLog log = log_of(signal(25.0, 0.01, constant_push));
  log.height = signal(25.0, 0.05, [=](double t) {
    const double coast = std::max(t - 7.0, 0.0);
    const double push = std::clamp(t - 5.0, 0.0, 2.0);
    return scale * (250.0 + 2.0 * g * push * push + 8.0 * g * coast - 0.5 * g * coast * coast);
  });
  return fly_log(std::move(log), question());
}

TEST(Doubts, OfAHeightInFeetThatWasGivenAsMetresNameBothHeights) {
  const Heard feet = with_height(1.0 / 0.3048);
  EXPECT_EQ(finding(feet), Finding::heard);
  EXPECT_TRUE(doubts(feet, "Up to apogee the log's own height gains 1287 m, and that of the law 39")) << text_of(feet);
  EXPECT_TRUE(doubts(feet, "feet given as metres")) << text_of(feet);
  EXPECT_EQ(answer(feet, {}).verdict.answer, result::Answer::undecided);
  const Heard metres_as_feet = with_height(0.3048);
  EXPECT_TRUE(doubts(metres_as_feet, "gains 120 m, and that of the law 39")) << text_of(metres_as_feet);
  EXPECT_FALSE(doubts(metres_as_feet, "feet given as metres"));
  for (const double sound : {0.55, 1.0, 1.9}) {
    EXPECT_TRUE(with_height(sound).doubts.empty()) << sound << " " << text_of(with_height(sound));
  }
}

}  // namespace
}  // namespace fantail::listen
