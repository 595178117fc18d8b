// SPDX-License-Identifier: MIT
// What is said of columns that are not what they were said to be, and of how the log was flown.
#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "listen/fly_log.hpp"
#include "listen/made_log.hpp"
#include "listen/sentences.hpp"
#include "text/number.hpp"

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

std::string in_ms(const Disagreement& all) { return text::brief(1e3 * all.in_all_s, 3); }
std::string first_s(const Disagreement& all) { return text::fixed(all.first_s, 3); }

// 1.85 g for 6 s is no lift-off by the rule; free fall, and then the shock of the parachute is.
double weak_push(double t) { return t < 5.0 ? g : t < 11.0 ? 1.85 * g : t < 18.0 ? 0.0 : t < 18.7 ? 5.0 * g : g; }

TEST(Doubts, OfALiftOffBehindAWeakPushAndAFallThatItIsTheParachute) {
  const Heard heard = fly_log(log_of(signal(30.0, 0.01, weak_push)), question());
  ASSERT_NEAR(heard.lift_off_s.value(), 18.0, 0.02);
  EXPECT_TRUE(doubts(heard, "parachute", {"4.99", "0.5", "1.5", "0.5"})) << text_of(heard);
  // Bumps of a tenth of a second on the way to the guide are none.
  const auto bumped = [](double t) { return t > 2.0 && t < 2.1 ? 0.1 * g : constant_push(t); };
  EXPECT_FALSE(doubts(fly_log(log_of(signal(20.0, 0.01, bumped)), question()), "parachute"));
}

TEST(Doubts, OfNoLiftOffWhereTheHeightRisesThatThereIsNone) {
  ImuLog log = log_of(signal(12.0, 0.01, weak_push));
  log.height = signal(12.0, 0.05, [](double t) { return t < 5.0 ? 100.0 : 100.0 + 4.0 * (t - 5.0) * (t - 5.0); });
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_EQ(finding(heard), Finding::no_launch);
  EXPECT_TRUE(doubts(heard, "height", {"196"})) << text_of(heard);
}

TEST(Doubts, OfAHeightWithoutASampleInTheFlightItsClockAndNotItsUnit) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  log.height = signal(3.0, 0.05, [](double) { return 100.0; });
  for (double& time_s : log.height.time_s) {
    time_s += 1000.0;
  }
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_TRUE(doubts(heard, "clock", {"5"})) << text_of(heard);
  EXPECT_EQ(heard.log_height.apogee_s, std::nullopt);
}

TEST(Doubts, OfASecondAccelerometerThatDoesNotReadOneGOnThePadAreThoseOfTheFirst) {
  const Heard in_g = with_second([](double t) { return constant_push(t) / g; });
  EXPECT_EQ(finding(in_g), Finding::missed);
  const auto times_named = [](const Heard& heard) {
    const std::string word = "second_axial_from_rest";
    std::size_t count = 0;
    for (std::size_t at = 0; (at = heard.doubts.at(0).find(word, at)) != std::string::npos; ++at) {
      ++count;
    }
    return count;
  };
  EXPECT_TRUE(doubts(in_g, "(second_axial_from_rest)", {"0.10", "1"})) << text_of(in_g);
  EXPECT_EQ(times_named(in_g), 2U) << "it is the guess, too; " << text_of(in_g);
  EXPECT_FALSE(doubts(in_g, "(axial")) << text_of(in_g);

  const Heard reversed = with_second([](double t) { return -constant_push(t); });
  EXPECT_TRUE(doubts(reversed, "minus", {"-1.00", "1"})) << text_of(reversed);
  const Heard half = with_second([](double t) { return 0.5 * constant_push(t); });
  EXPECT_TRUE(doubts(half, "(second_axial)", {"0.50", "1"})) << text_of(half);
  EXPECT_EQ(times_named(half), 1U) << "there is no guess; " << text_of(half);
  EXPECT_TRUE(with_second(constant_push).doubts.empty());
}

// It reads 1 g on the pad, and under thrust 1 g too little, then 3 g.
TEST(Doubts, SayThatTheLawRefusedALaunchBecauseTheTwoAccelerometersDisagree) {
  const auto short_of = [](double by_g) {
    return [=](double t) { return constant_push(t) - (t >= 5.0 && t < 7.0 ? by_g * g : 0.0); };
  };
  const Heard refused = with_second(short_of(1.0));
  EXPECT_EQ(finding(refused), Finding::missed);
  EXPECT_TRUE(doubts(refused, "accelerometers", {"0.5", "16", in_ms(refused.no_hold), first_s(refused.no_hold)}))
      << text_of(refused);
  EXPECT_FALSE(doubts(refused, "detection")) << "there was none; " << text_of(refused);
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
  EXPECT_TRUE(doubts(reversed, "accelerometers", {"1000", "4.993"})) << text_of(reversed);
}

TEST(Doubts, DoNotCountADisagreementThatTheLaunchWasHeardThrough) {
  const Heard shaken = with_second([](double t) { return constant_push(t) - (t >= 5.0 && t < 5.1 ? g : 0.0); });
  EXPECT_EQ(finding(shaken), Finding::heard);
  EXPECT_TRUE(shaken.doubts.empty()) << shaken.doubts[0];
  EXPECT_TRUE(says(shaken, "detection", {"0.5", "16", in_ms(shaken.no_hold), first_s(shaken.no_hold)}))
      << text_of(shaken);
}

// They agree for as long as the hold takes, and from then on differ by a g.
TEST(Doubts, SayThatTheLawHeldControlBackBecauseTheTwoAccelerometersDisagree) {
  const Heard held = with_second([](double t) { return constant_push(t) - (t >= 5.2 && t < 7.0 ? g : 0.0); });
  EXPECT_TRUE(held.detected_s);
  EXPECT_FALSE(held.control);
  EXPECT_TRUE(doubts(held, "guide", {in_ms(held.no_control), first_s(held.no_control)})) << text_of(held);
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
  // All of them, what is bridged, those before apogee, when samples are stale, and the longest of these.
  EXPECT_EQ(note_figures(heard, "gaps"),
            (Numbers{std::to_string(heard.gaps.size()), "100", "1", "5", "10.000", "10.500"}));
}

TEST(Notes, OfGapsThatAreAllBehindApogeeSaySo) {
  ImuLog log = log_of(signal(70.0, 0.01, constant_push));
  const auto is_lost = [](double t) { return t > 30.0 && std::fmod(t, 1.0) > 0.505; };
  std::erase_if(log.axial.value, [&, i = std::size_t{0}](double) mutable { return is_lost(log.axial.time_s[i++]); });
  std::erase_if(log.axial.time_s, is_lost);
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_EQ(note_figures(heard, "gaps"), (Numbers{std::to_string(heard.gaps.size()), "100"})) << text_of(heard);
  EXPECT_FALSE(says(heard, "old samples")) << text_of(heard);
}

TEST(Notes, OfALogFasterThanTheLawSayThatOnlyWhatFallsOnItsTicksIsUsed) {
  const auto flown = [](double interval_s) {
    return fly_log(log_of(signal(10.0, interval_s, constant_push), interval_s), question());
  };
  const Heard fast = flown(0.0005);
  // The log, the law, and in the faster log the motion that is mistaken.
  EXPECT_EQ(note_figures(fast, "interval"), (Numbers{"0.5", "2000", "1000", "500"})) << text_of(fast);
  EXPECT_EQ(note_figures(flown(0.001), "interval"), (Numbers{"1", "1000", "1000"}));
}

TEST(Doubts, OfALogWithAQuarterOfASecondBetweenSamplesAreThereFromExactlyThatOn) {
  const auto flown = [](double interval_s) {
    return fly_log(log_of(signal(20.0, interval_s, constant_push), interval_s), question());
  };
  EXPECT_TRUE(doubts(flown(0.25), "milliseconds"));
  EXPECT_TRUE(doubts(flown(0.3), "milliseconds"));
  EXPECT_FALSE(doubts(flown(0.24), "milliseconds"));
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
  const std::string law_m = text::fixed(feet.apogee_m, 0);
  EXPECT_NEAR(feet.apogee_m, 40.0 * g, 3.0);
  EXPECT_TRUE(doubts(feet, "feet", {"1287", law_m})) << text_of(feet);
  EXPECT_EQ(answer(feet, {}).verdict.answer, result::Answer::undecided);
  const Heard metres_as_feet = with_height(0.3048);
  EXPECT_TRUE(doubts(metres_as_feet, "unit", {"120", law_m})) << text_of(metres_as_feet);
  EXPECT_FALSE(doubts(metres_as_feet, "feet"));
  for (const double sound : {0.55, 1.0, 1.9}) {
    EXPECT_TRUE(with_height(sound).doubts.empty()) << sound << " " << text_of(with_height(sound));
  }
}

}  // namespace
}  // namespace fantail::listen
