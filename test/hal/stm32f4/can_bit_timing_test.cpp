// SPDX-License-Identifier: MIT
#include "hal/stm32f4/can_bit_timing.hpp"

#include <gtest/gtest.h>

namespace fantail::hal::stm32f4 {
namespace {

TEST(CanBitTiming, At42MHzABitIs21QuantaOfTwoPeriodsSampledAfter17) {
  const auto timing = can_bit_timing(42'000'000);
  ASSERT_TRUE(timing);
  // RM0090 section 32.9.2: BRP = 2 - 1, TS1 = 16 - 1, TS2 = 4 - 1, SJW = 4 - 1.
  EXPECT_EQ(timing->bits(), 0x033F'0001U);
}

TEST(CanBitTiming, OfTheProcessorsOwnOscillatorABitIsMadeToo) {
  const auto timing = can_bit_timing(16'000'000);
  ASSERT_TRUE(timing);
  EXPECT_EQ(timing->prescaler * (1 + timing->before_sample + timing->after_sample), 16U);
}

TEST(CanBitTiming, EveryClockGivesAFullMegabitAndASamplePointWithinItsLimitsOrNothing) {
  int made = 0;
  for (std::uint32_t clock_hz = 100'000; clock_hz <= 90'000'000; clock_hz += 1'000) {
    const auto timing = can_bit_timing(clock_hz);
    if (!timing) {
      continue;
    }
    made += 1;
    const std::uint32_t quanta = 1 + timing->before_sample + timing->after_sample;
    const double rate = clock_hz / static_cast<double>(timing->prescaler * quanta);
    const double sample = (1.0 + timing->before_sample) / quanta;
    ASSERT_NEAR(rate, 1e6, 1001.0) << clock_hz;
    ASSERT_GE(sample, 0.75) << clock_hz;
    ASSERT_LE(sample, 0.875) << clock_hz;
    // What the fields of BTR hold, and ISO 11898's fewest quanta.
    ASSERT_TRUE(timing->prescaler >= 1 && timing->prescaler <= 1024) << clock_hz;
    ASSERT_TRUE(timing->before_sample >= 1 && timing->before_sample <= 16) << clock_hz;
    ASSERT_TRUE(timing->after_sample >= 1 && timing->after_sample <= 8) << clock_hz;
    ASSERT_TRUE(timing->resynchronises >= 1 && timing->resynchronises <= 4) << clock_hz;
    ASSERT_LE(timing->resynchronises, timing->after_sample) << clock_hz;
    ASSERT_GE(quanta, 8U) << clock_hz;
  }
  EXPECT_GT(made, 0);
}

TEST(CanBitTiming, EveryWholeNumberOfMegahertzFrom8To45ThatHasAFittingDivisorIsUsed) {
  for (std::uint32_t mhz = 8; mhz <= 45; ++mhz) {
    bool possible = false;
    for (std::uint32_t quanta = 8; quanta <= 22; ++quanta) {
      possible = possible || mhz % quanta == 0;
    }
    EXPECT_EQ(can_bit_timing(mhz * 1'000'000).has_value(), possible) << mhz;
  }
}

TEST(CanBitTiming, AClockThatIsTooSlowOrOffIsRefused) {
  EXPECT_FALSE(can_bit_timing(0));
  EXPECT_FALSE(can_bit_timing(4'000'000));
  EXPECT_FALSE(can_bit_timing(16'500'000));
  EXPECT_TRUE(can_bit_timing(42'042'000));   // 0.1 %
  EXPECT_FALSE(can_bit_timing(42'085'000));  // 0.2 %
}

}  // namespace
}  // namespace fantail::hal::stm32f4
