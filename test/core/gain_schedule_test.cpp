// SPDX-License-Identifier: MIT
#include "core/gain_schedule.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace fantail::core {
namespace {

constexpr GainSchedulePlan schedule{
    .speeds_count = 3, .speeds_m_s = {20.0F, 40.0F, 80.0F}, .factors_count = 3, .factors = {4.0F, 1.0F, 0.25F}};

float at(float speed_m_s) { return gain_factor(schedule, speed_m_s, false); }

TEST(GainSchedule, WithoutRowsTheGainsAreAsTheyStand) {
  EXPECT_EQ(gain_factor(GainSchedulePlan{}, 50.0F, false), 1.0F);
  EXPECT_EQ(gain_factor(GainSchedulePlan{}, 50.0F, true), 1.0F);
}

TEST(GainSchedule, IsLinearBetweenItsRows) {
  EXPECT_EQ(at(20.0F), 4.0F);
  EXPECT_NEAR(at(25.0F), 3.25F, 1e-6F);
  EXPECT_EQ(at(40.0F), 1.0F);
  EXPECT_NEAR(at(70.0F), 0.4375F, 1e-6F);
}

TEST(GainSchedule, HoldsItsEnds) {
  EXPECT_EQ(at(-5.0F), 4.0F);
  EXPECT_EQ(at(0.0F), 4.0F);
  EXPECT_EQ(at(80.0F), 0.25F);
  EXPECT_EQ(at(500.0F), 0.25F);
}

// A line from 10 down to 0.01 is off by a millionth where it ends, for a float of 20 knows no more.
TEST(GainSchedule, AtTheSpeedOfARowItIsThatRowHoweverSteeplyTheLineEndsThere) {
  GainSchedulePlan steep{
      .speeds_count = 3, .speeds_m_s = {20.0F, 40.0F, 80.0F}, .factors_count = 3, .factors = {10.0F, 0.01F, 0.01F}};
  EXPECT_EQ(gain_factor(steep, 40.0F, false), 0.01F);
  steep.speeds_count = steep.factors_count = 2;
  EXPECT_EQ(gain_factor(steep, 40.0F, false), 0.01F) << "the last one";
}

// The one place of a line more than there are rows is the level one before the first.
TEST(GainSchedule, MayHaveSixRows) {
  const GainSchedulePlan full{.speeds_count = 6,
                              .speeds_m_s = {10.0F, 20.0F, 30.0F, 40.0F, 50.0F, 60.0F},
                              .factors_count = 6,
                              .factors = {32.0F, 16.0F, 8.0F, 4.0F, 2.0F, 1.0F}};
  EXPECT_EQ(gain_factor(full, 0.0F, false), 32.0F);
  for (int row = 0; row < 6; ++row) {
    EXPECT_NEAR(gain_factor(full, 10.0F * static_cast<float>(row + 1), false), static_cast<float>(1 << (5 - row)),
                1e-5F);
  }
  EXPECT_EQ(gain_factor(full, 99.0F, false), 1.0F);
}

TEST(GainSchedule, OfOneRowIsThatRowAtEverySpeed) {
  const GainSchedulePlan one{.speeds_count = 1, .speeds_m_s = {40.0F}, .factors_count = 1, .factors = {0.5F}};
  for (const float speed_m_s : {0.0F, 40.0F, 100.0F}) {
    EXPECT_EQ(gain_factor(one, speed_m_s, false), 0.5F);
  }
}

TEST(GainSchedule, ASpeedThatMayBeHigherTakesTheLastRow) { EXPECT_EQ(gain_factor(schedule, 25.0F, true), 0.25F); }

TEST(GainSchedule, ASpeedThatIsNoNumberTakesARow) {
  EXPECT_EQ(at(std::numeric_limits<float>::quiet_NaN()), 0.25F);
  EXPECT_EQ(at(std::numeric_limits<float>::infinity()), 0.25F);
}

}  // namespace
}  // namespace fantail::core
