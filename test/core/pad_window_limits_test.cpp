// SPDX-License-Identifier: MIT

#include "core/flight_plan_fields.hpp"
#include "core/pad_window.hpp"
#include "milliseconds.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

constexpr float g = standard_gravity_m_s2;

/// A rocket that stands still, sampled once a millisecond. Every sample is another one, so that a mean says which ones
/// are in it; all are whole 2^-20 rad/s and 2^-10 m/s2.
class Watched {
 public:
  explicit Watched(const MotionPlan& plan = default_plan().motion) : window{plan} {}

  static Vector3 rate(int sample) {
    const float r = static_cast<float>(sample % 20'000) * 0x1p-22F;
    return {r, -r, 2.0F * r};
  }
  static Vector3 force(int sample) {
    const float f = static_cast<float>(sample % 1'000) * 0x1p-10F;
    return {9.75F, 0.25F * f, -0.25F * f};
  }

  void stand(int begin_ms, int end_ms, int step_ms = 1) {
    for (int t = begin_ms; t < end_ms; t += step_ms) {
      if (window.update(ms(t), rate(t), force(t))) {
        renewed_ms.push_back(t);
      }
    }
  }
  void move(int begin_ms, int end_ms) {
    for (int t = begin_ms; t < end_ms; ++t) {
      EXPECT_FALSE(window.update(ms(t), {0.0F, 1.0F, 0.0F}, force(t))) << t;
    }
  }
  /// Of the samples begin_ms <= t < end_ms, each axis of both sensors.
  void expect_mean(int begin_ms, int end_ms, int step_ms = 1) const {
    std::array<double, 6> sum{};
    int samples = 0;
    for (int t = begin_ms; t < end_ms; t += step_ms, ++samples) {
      const std::array values{rate(t).x, rate(t).y, rate(t).z, force(t).x, force(t).y, force(t).z};
      for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += static_cast<double>(values[i]);
      }
    }
    ASSERT_TRUE(window.average());
    const auto& [bias, mean_force] = *window.average();
    const std::array found{bias.x, bias.y, bias.z, mean_force.x, mean_force.y, mean_force.z};
    for (std::size_t i = 0; i < sum.size(); ++i) {
      EXPECT_NEAR(found[i], sum[i] / samples, i < 3 ? 5e-8 : 1e-5) << i;
    }
  }

  PadWindow window;
  std::vector<int> renewed_ms;
};

std::vector<int> tenths_of_a_second(int first_ms, int last_ms) {
  std::vector<int> result;
  for (int t = first_ms; t <= last_ms; t += 100) {
    result.push_back(t);
  }
  return result;
}

TEST(PadWindow, EveryTenthOfASecondTheAverageIsThatOfAllSamplesOfTheThreeSecondsThatEndedHalfASecondAgo) {
  Watched rocket;
  rocket.stand(0, 3'501);
  rocket.expect_mean(0, 3'000);
  rocket.stand(3'501, 4'001);
  rocket.expect_mean(500, 3'500);
  rocket.stand(4'001, 11'000);
  rocket.expect_mean(7'400, 10'400);
  EXPECT_EQ(rocket.renewed_ms, tenths_of_a_second(3'500, 10'900));
}

TEST(PadWindow, AMicrosecondBeforeATenthOfASecondIsOverNothingIsRenewed) {
  Watched rocket;
  rocket.stand(0, 3'500);
  EXPECT_FALSE(rocket.window.update(Microseconds{3'499'999}, {}, {g, 0.0F, 0.0F}));
  EXPECT_TRUE(rocket.window.update(Microseconds{3'500'000}, {}, {g, 0.0F, 0.0F}));
}

TEST(PadWindow, AMomentOfMotionVoidsTheTenthOfASecondInWhichItFalls) {
  Watched rocket;
  rocket.stand(0, 5'030);
  rocket.move(5'030, 5'050);
  rocket.stand(5'050, 5'501);
  rocket.expect_mean(2'000, 5'000);
  rocket.stand(5'501, 8'600);
  rocket.expect_mean(2'000, 5'000);
  rocket.stand(8'600, 9'001);
  rocket.expect_mean(5'500, 8'500);
  std::vector<int> expected = tenths_of_a_second(3'500, 5'500);
  const std::vector<int> after = tenths_of_a_second(8'600, 9'000);
  expected.insert(expected.end(), after.begin(), after.end());
  EXPECT_EQ(rocket.renewed_ms, expected);
}

TEST(PadWindow, AfterALongMotionTheFirstAverageIsThatOfThreeSecondsOfRestBehindIt) {
  for (const bool stood_before : {true, false}) {
    Watched rocket;
    if (stood_before) {
      rocket.stand(0, 5'000);
    }
    rocket.move(stood_before ? 5'000 : 0, 15'050);
    rocket.renewed_ms.clear();
    rocket.stand(15'050, 18'601);
    EXPECT_EQ(rocket.renewed_ms, std::vector{18'600});
    rocket.expect_mean(15'100, 18'100);
  }
}

TEST(PadWindow, SensorsThatFailForAMomentEndTheRestAndVoidTheTenthOfASecondInWhichTheyFail) {
  Watched rocket;
  rocket.stand(0, 3'701);
  for (int t = 3'701; t < 3'705; ++t) {
    rocket.window.interrupt(ms(t));
    EXPECT_EQ(rocket.window.at_rest_for(ms(t)), ms(0));
  }
  rocket.stand(3'705, 7'300);
  EXPECT_EQ(rocket.renewed_ms, (std::vector{3'500, 3'600, 3'700, 3'800, 3'900, 4'000, 4'100, 4'200}));
  rocket.stand(7'300, 7'401);
  rocket.expect_mean(3'900, 6'900);
}

TEST(PadWindow, AfterAGapOfMoreThanTheStaleTimeOrAStepBackTheWindowBeginsWithTheNextSample) {
  for (const int next_ms : {4'048, 4'041}) {
    Watched rocket;
    rocket.stand(0, 4'043);  // the last one at 4042 ms, while a tenth of a second is open
    rocket.renewed_ms.clear();
    rocket.stand(next_ms, next_ms + 3'501);
    EXPECT_EQ(rocket.renewed_ms, std::vector{next_ms + 3'500}) << next_ms;
    rocket.expect_mean(next_ms, next_ms + 3'000);
  }
}

TEST(PadWindow, AGapOfExactlyTheStaleTimeIsNoneAndATimeThatIsRepeatedIsNoStepBack) {
  MotionPlan plan = default_plan().motion;
  plan.stale_time = ms(5);
  for (const int next_ms : {4'047, 4'042}) {
    Watched rocket{plan};
    rocket.stand(0, 4'043);
    rocket.renewed_ms.clear();
    rocket.stand(next_ms, 4'401);
    EXPECT_EQ(rocket.renewed_ms, tenths_of_a_second(4'100, 4'400));
    EXPECT_EQ(rocket.window.at_rest_for(ms(4'400)), ms(4'400));
  }
}

TEST(PadWindow, OneSampleInATenthOfASecondIsEnough) {
  MotionPlan plan = default_plan().motion;
  plan.stale_time = ms(100);
  Watched rocket{plan};
  rocket.stand(0, 3'501, 100);
  EXPECT_EQ(rocket.renewed_ms, std::vector{3'500});
  rocket.expect_mean(0, 3'000, 100);
}

TEST(PadWindow, WhatIsExactlyAsFarFromOneGAndTurnsExactlyAsFastAsThePlanAllowsIsAtRest) {
  MotionPlan plan = default_plan().motion;
  plan.rest_tolerance_m_s2 = 1.0F;
  plan.quiet_rate_rad_s = 0.0625F;
  const auto rests = [&](float rate_rad_s, float force_m_s2) {
    PadWindow window{plan};
    window.update(ms(0), {0.0F, rate_rad_s, 0.0F}, {0.0F, force_m_s2, 0.0F});
    return window.at_rest_for(ms(1)) == ms(1);
  };
  const auto beyond = [](float value) { return std::nextafter(value, 100.0F); };
  const auto short_of = [](float value) { return std::nextafter(value, 0.0F); };
  EXPECT_TRUE(rests(0.0625F, g));
  EXPECT_FALSE(rests(beyond(0.0625F), g));
  EXPECT_TRUE(rests(-0.0625F, g));
  EXPECT_FALSE(rests(-beyond(0.0625F), g));
  EXPECT_TRUE(rests(0.0F, g + 1.0F));
  EXPECT_FALSE(rests(0.0F, beyond(g + 1.0F)));
  EXPECT_TRUE(rests(0.0F, g - 1.0F));
  EXPECT_FALSE(rests(0.0F, short_of(g - 1.0F)));
}

// The square of the force goes from g^2 to (1.5 g)^2 as 1 - exp(-t / T), T = 1 / (2 pi 16 Hz), and is that of 1.1 g
// after 1.82 ms: ln(1 / (1 - 0.21 / 1.25)) T.
TEST(PadWindow, AStepOfTheForceIsMotionWhenItsSquareHasComeThroughALowPassOf16Hertz) {
  MotionPlan plan = default_plan().motion;
  plan.rest_tolerance_m_s2 = 0.1F * g;
  for (const int t_us : {1'770, 1'880}) {
    PadWindow window{plan};
    window.update(Microseconds{0}, {}, {g, 0.0F, 0.0F});
    window.update(Microseconds{t_us}, {}, {0.0F, 1.5F * g, 0.0F});
    EXPECT_EQ(window.at_rest_for(ms(10)) == ms(10), t_us < 1'820) << t_us;
  }
}

}  // namespace
}  // namespace fantail::core
