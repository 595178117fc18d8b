// SPDX-License-Identifier: MIT
// What is said of logs with launches that were none, late ones and doubtful columns.
#include <random>

#include <gtest/gtest.h>

#include "listen/fly_log.hpp"
#include "listen/made_log.hpp"
#include "listen/sentences.hpp"
#include "seed.hpp"
#include "text/number.hpp"

namespace fantail::listen {
namespace {

using namespace made;

std::string since_lift_off(const Heard& heard) {
  return text::fixed(std::abs(heard.since_lift_off_s(heard.detected_s).value()), 3);
}

// 120 ms of 10 g fire the detector; the guide is not cleared, and after two seconds at rest the law listens again.
TEST(FlyLog, WithAKnockBeforeTheLaunchNamesTheLaunchThatWasNone) {
  const auto knocked = [](double width_s) {
    return [=](double t) { return t > 4.0 && t < 4.0 + width_s ? 10.0 * g : t < 10.0 ? g : constant_push(t - 5.0); };
  };
  const Heard heard = fly_log(log_of(signal(25.0, 0.01, knocked(0.12))), question());
  EXPECT_EQ(finding(heard), Finding::imagined);
  ASSERT_EQ(heard.false_detections_s.size(), 1U);
  EXPECT_NEAR(heard.false_detections_s[0], 4.1, 0.02);
  EXPECT_NEAR(heard.since_lift_off_s(heard.detected_s).value(), 0.11, 0.01);
  EXPECT_EQ(figures(headline(heard)), (Numbers{since_lift_off(heard), "9.99"})) << headline(heard);
  EXPECT_EQ(finding(fly_log(log_of(signal(25.0, 0.01, knocked(0.04))), question())), Finding::heard);
}

// 3 g above the pad's for 0.25 s; the boost begins before the law has seen its two seconds at rest, and after.
TEST(FlyLog, WithABumpThatLastsNamesItAndTheLaunchThatIsMissedForIt) {
  const auto bumped = [](double launch_s) {
    return fly_log(log_of(signal(launch_s + 12.0, 0.01,
                                 [=](double t) {
                                   return t > 4.0 && t < 4.25 ? 4.0 * g
                                                              : constant_push(t < launch_s ? 0.0 : t - launch_s + 5.0);
                                 })),
                   question());
  };
  const Heard missed = bumped(6.0);
  EXPECT_EQ(finding(missed), Finding::imagined_and_missed);
  EXPECT_NEAR(missed.lift_off_s.value(), 6.0, 0.011);
  ASSERT_EQ(missed.false_detections_s.size(), 1U);
  EXPECT_NEAR(missed.false_detections_s[0], 4.1, 0.02);
  EXPECT_EQ(missed.detected_s, std::nullopt);
  EXPECT_EQ(figures(headline(missed)), Numbers{"5.99"}) << headline(missed);
  EXPECT_EQ(data_of(missed)["finding"], "imagined_and_missed");

  const Heard after = bumped(12.0);
  EXPECT_EQ(finding(after), Finding::imagined);
  EXPECT_NEAR(after.since_lift_off_s(after.detected_s).value(), 0.11, 0.01);

  const Heard through = bumped(4.6);
  EXPECT_EQ(finding(through), Finding::imagined);
  EXPECT_NEAR(through.since_lift_off_s(through.detected_s).value(), -0.49, 0.02);
  EXPECT_TRUE(through.control) << "the law was in Launched when the rocket left";
  EXPECT_EQ(figures(headline(through)), Numbers{since_lift_off(through)}) << headline(through);
  EXPECT_NE(headline(through).find("before lift-off"), std::string::npos) << headline(through);
}

TEST(FlyLog, OfOneStrokeByHandIsALaunchThatWasNone) {
  const auto stroke = [](double width_s) {
    ImuLog log = log_of(signal(12.0, 0.01, [=](double t) { return t > 5.0 && t < 5.0 + width_s ? 4.0 * g : g; }));
    log.height = signal(12.0, 0.1, [](double) { return 0.0; });
    return fly_log(std::move(log), question());
  };
  for (const double width_s : {0.13, 0.20, 0.30}) {
    const Heard heard = stroke(width_s);
    EXPECT_EQ(finding(heard), Finding::imagined) << width_s;
    EXPECT_EQ(heard.lift_off_s, std::nullopt) << width_s;
    EXPECT_EQ(heard.false_detections_s.size(), 1U) << width_s;
    EXPECT_NE(headline(heard).find("lift-off"), std::string::npos) << headline(heard);
    EXPECT_EQ(figures(headline(heard)), Numbers{}) << headline(heard);
  }
}

// 17 m/s within half a second are beyond the gates of guide and speed: the canards would have moved.
TEST(FlyLog, OfAPushThatPassesTheGatesSaysThatControlBegan) {
  Question easy = question();
  easy.plan.guide.length_m = 1.0F;
  easy.plan.guide.clearance_m = 0.1F;
  const Heard heard =
      fly_log(log_of(signal(12.0, 0.01, [](double t) { return t > 5.0 && t < 5.22 ? 9.0 * g : g; })), easy);
  EXPECT_EQ(finding(heard), Finding::imagined);
  ASSERT_TRUE(heard.early_control_s);
  EXPECT_NEAR(*heard.early_control_s, 5.2, 0.1);
  EXPECT_NE(headline(heard).find("Control began"), std::string::npos) << headline(heard);
  EXPECT_EQ(figures(headline(heard)), Numbers{text::fixed(*heard.early_control_s, 3)}) << headline(heard);
  EXPECT_FALSE(heard.control);
}

TEST(FlyLog, DetectedSecondsAfterLiftOffIsLateAndNotGreen) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  log.second_axial = signal(20.0, 0.01, [](double t) { return t < 6.5 ? g : constant_push(t); });
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_NEAR(heard.since_lift_off_s(heard.detected_s).value(), 1.61, 0.02);
  EXPECT_EQ(finding(heard), Finding::late);
  EXPECT_NE(headline(heard).find("late"), std::string::npos) << headline(heard);
  EXPECT_EQ(data_of(heard)["finding"], "late");
  EXPECT_EQ(answer(heard, {}).verdict.answer, result::Answer::no);
}

// axial_from_rest where axial was meant: the pad reads 2 g, and the whole log lies above the threshold of lift-off.
TEST(FlyLog, WithGravityTwiceDoubtsThePad) {
  std::mt19937 random{test::seed()};
  std::normal_distribution<double> noise{0.0, 0.2};
  const Heard heard =
      fly_log(log_of(signal(12.0, 0.01, [&](double t) { return constant_push(t) + g + noise(random); })), question());
  EXPECT_EQ(finding(heard), Finding::missed) << "pushed for more than three seconds, for the law it has moved";
  EXPECT_TRUE(doubts(heard, "twice")) << text_of(heard);
}

TEST(FlyLog, OfALogThatBeginsInThrustSaysThatNothingBeforeItIsKnown) {
  const Heard heard = fly_log(log_of(signal(10.0, 0.01, [](double t) { return t < 2.0 ? 5.0 * g : 0.0; })), question());
  EXPECT_EQ(finding(heard), Finding::heard);
  EXPECT_EQ(figures(headline(heard)), Numbers{since_lift_off(heard)}) << "and no time before it";
  EXPECT_TRUE(doubts(heard, "first sample", {"2"}));
}

TEST(FlyLog, WhoseHeightStandsStillAfterLiftOffDoubtsTheFlight) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  log.height = signal(20.0, 0.1, [](double t) { return 100.0 + std::fmod(t, 0.5); });
  const Heard flat = fly_log(std::move(log), question());
  EXPECT_TRUE(doubts(flat, "height", {"0.2", "5"})) << "0 to 0.4 m about a mean of 0.2; " << text_of(flat);
}

TEST(FlyLog, OfTwoLaunchesJudgesTheFirstAndNamesTheOther) {
  const auto two = [](double t) { return constant_push(t < 60.0 ? t : t - 60.0); };
  const Heard heard = fly_log(log_of(signal(80.0, 0.01, two)), question());
  EXPECT_EQ(finding(heard), Finding::heard);
  EXPECT_EQ(note_figures(heard, "landing"), Numbers{"64.99"});
  EXPECT_EQ(heard.further_lift_offs_s.size(), 1U);
  EXPECT_TRUE(heard.doubts.empty());
  EXPECT_NEAR(data_of(heard)["further_lift_offs_s"][0].number(), 64.99, 0.01);
  EXPECT_FALSE(says(fly_log(log_of(signal(20.0, 0.01, constant_push)), question()), "landing"));
}

// Of the first launch the second accelerometer says nothing, and the plan asks for two.
// What falls after the first has flown, and the law knows it.
TEST(FlyLog, ThatMissesTheFirstOfTwoLaunchesHearsNoSecond) {
  ImuLog log = log_of(signal(80.0, 0.01, [](double t) { return constant_push(t < 60.0 ? t : t - 60.0); }));
  log.second_axial = signal(80.0, 0.01, [](double t) { return t < 60.0 ? g : constant_push(t - 60.0); });
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_EQ(heard.detected_s, std::nullopt);
  EXPECT_EQ(finding(heard), Finding::missed);
}

// Nothing between 4.9 s and 5.6 s, in which the push begins at 5.0 s; half a second of it is bridged by nobody.
TEST(FlyLog, WhoseLiftOffLiesInAGapGivesItNoTimeAndDoubtsIt) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  std::erase_if(log.axial.value, [&, i = 0](double) mutable {
    const double t = log.axial.time_s[static_cast<std::size_t>(i++)];
    return t > 4.905 && t < 5.595;
  });
  std::erase_if(log.axial.time_s, [](double t) { return t > 4.905 && t < 5.595; });
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_EQ(finding(heard), Finding::heard);
  EXPECT_TRUE(doubts(heard, "gap", {"4.900", "5.600"})) << text_of(heard);
  EXPECT_NEAR(heard.detected_s.value(), 5.70, 0.005) << "a hold behind the gap";
  EXPECT_EQ(heard.since_lift_off_s(heard.detected_s), std::nullopt);
  EXPECT_EQ(figures(headline(heard)),
            (Numbers{text::fixed(*heard.detected_s - 5.6, 3), text::fixed(*heard.detected_s - 4.9, 3), "4.90"}))
      << headline(heard);
  EXPECT_NE(headline(heard).find("gap"), std::string::npos) << headline(heard);
  const json::Value data = data_of(heard);
  EXPECT_TRUE(data["lift_off_s"].is_null());
  EXPECT_NEAR(data["lift_off_gap"]["from_s"].number(), 4.9, 1e-6);
  EXPECT_NEAR(data["lift_off_gap"]["to_s"].number(), 5.6, 1e-6);
  EXPECT_EQ(page_of(heard).find("time after lift-off"), std::string::npos);
}

TEST(FlyLog, WhosePushIsJudgedAcrossAGapDoubtsIt) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  std::erase_if(log.axial.value, [&, i = 0](double) mutable {
    const double t = log.axial.time_s[static_cast<std::size_t>(i++)];
    return t > 5.105 && t < 5.595;
  });
  std::erase_if(log.axial.time_s, [](double t) { return t > 5.105 && t < 5.595; });
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_NEAR(heard.lift_off_s.value(), 4.9925, 1e-6);
  EXPECT_TRUE(doubts(heard, "gap", {"0.11"})) << text_of(heard);
}

TEST(FlyLog, WhoseHeadlineSaysHowMuchOfTheTimeBeforeLiftOffHasNoSamples) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  Signal kept{.words = "a"};
  for (std::size_t i = 0; i < log.axial.time_s.size(); ++i) {
    if (const double t = log.axial.time_s[i]; t < 0.495 || t > 4.705) {
      kept.time_s.push_back(t);
      kept.value.push_back(log.axial.value[i]);
    }
  }
  log.axial = kept;
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_EQ(finding(heard), Finding::heard);
  EXPECT_EQ(figures(headline(heard)), (Numbers{since_lift_off(heard), "4.99", "4.22"})) << headline(heard);
}

// Of its own gyro the law would say the same; here it is the log that says nothing.
TEST(FlyLog, WhoseGapTheLawTakesForAGyroThatFailedDoubtsWhatCameOfIt) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  log.roll_rate = signal(20.0, 0.01, [](double t) { return 0.1 * t; });
  for (Signal* one : {&log.axial, &log.roll_rate}) {
    Signal kept{.words = one->words};
    for (std::size_t i = 0; i < one->time_s.size(); ++i) {
      if (const double t = one->time_s[i]; t < 5.325 || t > 5.635) {
        kept.time_s.push_back(t);
        kept.value.push_back(one->value[i]);
      }
    }
    *one = kept;
  }
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_FALSE(heard.control) << text_of(heard);
  EXPECT_TRUE(doubts(heard, "gyro", {"5.320", "5.640"})) << text_of(heard);
}

// Rows whose rate alone is missing, as empty cells are.
TEST(FlyLog, WithoutARateWhileTheForceGoesOnDoubtsAGyroThatFailed) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  log.roll_rate = signal(20.0, 0.01, [](double t) { return 0.1 * t; });
  std::erase_if(log.roll_rate.time_s, [](double t) { return t > 5.325 && t < 6.325; });
  log.roll_rate.value.clear();
  std::ranges::transform(log.roll_rate.time_s, std::back_inserter(log.roll_rate.value),
                         [](double t) { return 0.1 * t; });
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_FALSE(heard.control) << text_of(heard);
  EXPECT_TRUE(doubts(heard, "gyro")) << text_of(heard);
}

// A rocket that is carried uphill: its height has a top, which is no apogee of a flight.
TEST(FlyLog, WithoutLiftOffHasNoApogeeAndNoTimeAfterIt) {
  ImuLog log = log_of(signal(10.0, 0.01, [](double) { return g; }));
  log.height = signal(10.0, 0.1, [](double t) { return 100.0 + 5.0 * t - 0.5 * t * t; });
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_EQ(heard.lift_off_s, std::nullopt);
  EXPECT_EQ(heard.log_height.apogee_s, std::nullopt);
  for (const char* const side : {"law", "log_itself"}) {
    EXPECT_TRUE(data_of(heard)[side]["apogee_m"].is_null()) << side;
  }
  EXPECT_NE(text_of(heard).find("0.00 s"), std::string::npos) << "on the log's clock; " << text_of(heard);
  EXPECT_EQ(page_of(heard).find("apogee, log"), std::string::npos);
}

TEST(FlyLog, SaysItsDoubtsBeforeItsFinding) {
  const Heard reversed = fly_log(log_of(signal(10.0, 0.01, [](double t) { return -constant_push(t); })), question());
  const std::string text = text_of(reversed);
  EXPECT_TRUE(doubts(reversed, "minus", {"-1.00", "1"})) << text;
  EXPECT_NE(answer(reversed, {}).verdict.heading.find("doubt"), std::string::npos) << text;
  const std::size_t doubt = text.find("-1.00 g");
  ASSERT_NE(doubt, std::string::npos) << text;
  EXPECT_LT(doubt, text.find(headline(reversed).substr(0, 20))) << text;
  EXPECT_EQ(text.find("Before lift-off"), std::string::npos) << text;
  EXPECT_GE(data_of(reversed)["doubts"].size(), 1U);
}

}  // namespace
}  // namespace fantail::listen
