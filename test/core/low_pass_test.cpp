// SPDX-License-Identifier: MIT
#include "core/low_pass.hpp"

#include "milliseconds.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

constexpr double tau_16_hz_s = 1.0 / (2.0 * std::numbers::pi * 16.0);

TEST(LagFraction, FollowsTheExponentialForTheStepsOfAControlLoop) {
  for (int i = 0; i <= 50; ++i) {
    const double x = 0.01 * i;
    EXPECT_NEAR(lag_fraction(static_cast<float>(x)), 1.0 - std::exp(-x), x * x * x * x / 24.0 + 2e-7) << x;
  }
}

TEST(LagFraction, StaysFromZeroToOneHoweverLateTheSample) {
  for (const float x : {0.0F, 1e-30F, 1.0F, 10.0F, 1e6F, 1e20F, std::numeric_limits<float>::infinity()}) {
    EXPECT_GE(lag_fraction(x), 0.0F) << x;
    EXPECT_LE(lag_fraction(x), 1.0F) << x;
  }
}

TEST(LagFraction, IsZeroForAClockThatRunsBackwards) {
  for (const float x : {-1e-6F, -1.0F, -1.5960717F, -2.0F, -1e20F, -std::numeric_limits<float>::infinity(),
                        std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_EQ(lag_fraction(x), 0.0F) << x;
  }
}

TEST(LowPass, IsPrimedByTheFirstSample) {
  LowPass low_pass{16.0F};
  EXPECT_FALSE(low_pass.output());
  EXPECT_EQ(low_pass.update(one_ms, 9.81F), 9.81F);
  EXPECT_EQ(low_pass.output(), 9.81F);
}

TEST(LowPass, StepResponseIsTheExponentialAtAnySampleInterval) {
  for (const int interval_us : {250, 1000, 2500, 4000}) {
    LowPass low_pass{16.0F};
    low_pass.update(Microseconds{0}, 0.0F);
    for (int t_us = interval_us; t_us <= 100'000; t_us += interval_us) {
      const float output = low_pass.update(Microseconds{t_us}, 1.0F);
      EXPECT_NEAR(output, 1.0 - std::exp(-t_us * 1e-6 / tau_16_hz_s), 1e-3) << interval_us << " us, t " << t_us;
    }
  }
}

TEST(LowPass, RepeatedTimeChangesNothing) {
  LowPass low_pass{16.0F};
  low_pass.update(Microseconds{0}, 1.0F);
  const float before = low_pass.update(one_ms, 2.0F);
  EXPECT_EQ(low_pass.update(one_ms, 50.0F), before);
}

TEST(LowPass, RepeatedTimeChangesNothingAlsoRightAfterTheFirstSample) {
  LowPass low_pass{16.0F};
  low_pass.update(one_ms, 1.0F);
  EXPECT_EQ(low_pass.update(one_ms, 50.0F), 1.0F);
}

TEST(LowPass, AFirstStepOfAWholeSecondArrivesWhollyAtItsInput) {
  LowPass low_pass{16.0F};  // a hundred time constants
  low_pass.update(Microseconds{0}, 0.0F);
  EXPECT_NEAR(low_pass.update(Microseconds{1'000'000}, 1.0F), 1.0F, 1e-5F);
}

TEST(LowPass, SurvivesAClockThatRunsBackwards) {
  LowPass low_pass{16.0F};
  low_pass.update(Microseconds{100'000}, 1.0F);
  // At minus 1.596 time constants the series in lag_fraction has a zero.
  EXPECT_EQ(low_pass.update(Microseconds{100'000 - 15'877}, 5.0F), 1.0F);
  EXPECT_NEAR(low_pass.update(Microseconds{184'123}, 5.0F), 5.0F, 5e-2F);
}

TEST(LowPass, AfterAResetTheNextSamplePrimesItAgain) {
  LowPass low_pass{16.0F};
  low_pass.update(Microseconds{0}, 1.0F);
  low_pass.reset();
  EXPECT_FALSE(low_pass.output());
  EXPECT_EQ(low_pass.update(one_ms, 7.0F), 7.0F);
}

TEST(LowPass, ResolvesMicrosecondsAfterADayOfWaiting) {
  LowPass early{16.0F};
  LowPass late{16.0F};
  const Microseconds day{86'400'000'000};
  for (int i = 0; i < 50; ++i) {
    const Microseconds t{i * 997};
    const float input = i % 7 < 3 ? 20.0F : 9.81F;
    EXPECT_EQ(early.update(t, input), late.update(day + t, input));
  }
}

}  // namespace
}  // namespace fantail::core
