// SPDX-License-Identifier: MIT
#include "core/trig.hpp"

#include "test.hpp"

namespace fantail::core {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float smallest = std::numeric_limits<float>::denorm_min();

float sine(float radians) { return core::sin(Angle::from_radians(radians)); }
float cosine(float radians) { return core::cos(Angle::from_radians(radians)); }

// The largest distance from the double result over a sweep: absolute, and in units in the last place of the float
// result where that is not near a zero.
struct Error {
  double absolute = 0.0;
  double units = 0.0;
  void note(float found, double expected, double near_zero) {
    const double distance = std::abs(static_cast<double>(found) - expected);
    absolute = std::max(absolute, distance);
    if (std::abs(expected) > near_zero) {
      const auto size = static_cast<float>(std::abs(expected));
      units = std::max(units, distance / static_cast<double>(std::nextafter(size, infinity) - size));
    }
  }
};

template <typename Function>
void sweep(double first, double last, int points, Function function) {
  for (int i = 0; i <= points; ++i) {
    function(static_cast<float>(first + (last - first) * i / points));
  }
}

TEST(Trig, SineAndCosineKeepTheErrorTheyPromiseOverTheirWholeRange) {
  Error error;
  for (const double reach : {0.1, 1.0, 7.0, 100.0, 10000.0}) {
    sweep(-reach, reach, 1'000'000, [&](float x) {
      error.note(sine(x), std::sin(static_cast<double>(x)), 0.01);
      error.note(cosine(x), std::cos(static_cast<double>(x)), 0.01);
    });
  }
  EXPECT_LT(error.absolute, 1.1e-7);
  EXPECT_LT(error.units, 2.0);
}

TEST(Trig, SineKeepsItsUnitsInTheLastPlaceNearZero) {
  Error error;
  sweep(-0.01, 0.01, 1'000'000, [&](float x) { error.note(sine(x), std::sin(static_cast<double>(x)), 0.0); });
  EXPECT_LT(error.units, 2.0);
  EXPECT_EQ(sine(smallest), smallest);
  EXPECT_EQ(sine(-smallest), -smallest);
  EXPECT_EQ(sine(0.0F), 0.0F);
  EXPECT_EQ(sine(-0.0F), 0.0F);
  EXPECT_EQ(cosine(smallest), 1.0F);
}

TEST(Trig, SineOfTurnsKeepsItsErrorToAMillionTurns) {
  Error error;
  for (const double reach : {0.5, 2.0, 1000.0, 1e6}) {
    sweep(-reach, reach, 1'000'000, [&](float turns) {
      const double phase = std::fmod(static_cast<double>(turns), 1.0);
      error.note(sin_turns(turns), std::sin(2.0 * std::numbers::pi * phase), 0.01);
    });
  }
  EXPECT_LT(error.absolute, 1.1e-7);
  EXPECT_LT(error.units, 2.0);
}

TEST(Trig, SineOfWholeAndQuarterTurnsIsExact) {
  for (int turns = -999'999; turns <= 999'999; turns += 1001) {
    const auto whole = static_cast<float>(turns);
    EXPECT_EQ(sin_turns(whole), 0.0F) << turns;
    EXPECT_EQ(sin_turns(whole + 0.25F), 1.0F) << turns;
    EXPECT_EQ(sin_turns(whole - 0.25F), -1.0F) << turns;
    EXPECT_EQ(sin_turns(whole + 0.5F), 0.0F) << turns;
  }
}

TEST(Trig, ArcTangentKeepsItsErrorInEveryOctantAndAtEverySize) {
  Error error;
  for (const double size : {1e-37, 1e-20, 1e-3, 1.0, 1e3, 1e20, 1e37}) {
    sweep(-std::numbers::pi, std::numbers::pi, 1'000'000, [&](float direction) {
      const auto y = static_cast<float>(size * std::sin(static_cast<double>(direction)));
      const auto x = static_cast<float>(size * std::cos(static_cast<double>(direction)));
      if (y != 0.0F) {  // the sign of a zero is told apart by the C library, and not here
        error.note(core::atan2(y, x).radians(), std::atan2(static_cast<double>(y), static_cast<double>(x)), 0.0);
      }
    });
  }
  EXPECT_LT(error.absolute, 3.0e-7);
  EXPECT_LT(error.units, 3.5);
}

TEST(Trig, ArcTangentOfTheAxesIsExact) {
  EXPECT_EQ(core::atan2(0.0F, 0.0F), Angle{});
  EXPECT_EQ(core::atan2(-0.0F, -0.0F), Angle{});
  EXPECT_EQ(core::atan2(0.0F, 2.0F), Angle{});
  EXPECT_EQ(core::atan2(2.0F, 0.0F).radians(), pi / 2.0F);
  EXPECT_EQ(core::atan2(-2.0F, 0.0F).radians(), -pi / 2.0F);
  EXPECT_EQ(core::atan2(0.0F, -2.0F).radians(), pi);
  EXPECT_EQ(core::atan2(-0.0F, -2.0F).radians(), pi);
  EXPECT_EQ(core::atan2(smallest, smallest).radians(), pi / 4.0F);
}

TEST(Trig, ArcTangentIsTheNearestFloatWhereTheSlopesThatAreFoldedBegin) {
  constexpr float slope = 0.4142135623730950F;  // tan(pi / 8)
  EXPECT_EQ(core::atan2(slope, 1.0F).radians(), static_cast<float>(std::atan(static_cast<double>(slope))));
}

TEST(Trig, EveryFunctionIsOddOrEvenToTheLastBit) {
  sweep(0.0, 10000.0, 200'000, [](float x) {
    ASSERT_EQ(sine(-x), -sine(x)) << x;
    ASSERT_EQ(cosine(-x), cosine(x)) << x;
    ASSERT_EQ(sin_turns(-x), -sin_turns(x)) << x;
    ASSERT_EQ(core::atan2(-x - 1.0F, 100.0F), -core::atan2(x + 1.0F, 100.0F)) << x;
  });
}

TEST(Trig, WhatCannotBeComputedIsNotANumberInsteadOfAWrongOne) {
  for (const float bad : {infinity, -infinity, not_a_number, 10000.01F, -10000.01F, 1e30F}) {
    EXPECT_TRUE(std::isnan(sine(bad))) << bad;
    EXPECT_TRUE(std::isnan(cosine(bad))) << bad;
  }
  for (const float bad : {infinity, -infinity, not_a_number, 1000001.0F, -1000001.0F, 1e30F}) {
    EXPECT_TRUE(std::isnan(sin_turns(bad))) << bad;
  }
  for (const float sense : {1.0F, -1.0F}) {
    EXPECT_FALSE(std::isnan(sine(sense * 10000.0F)));
    EXPECT_FALSE(std::isnan(cosine(sense * 10000.0F)));
    EXPECT_FALSE(std::isnan(sin_turns(sense * 1e6F)));
  }
}

TEST(Trig, ArcTangentTakesOneInfinityAndRefusesTwo) {
  EXPECT_EQ(core::atan2(infinity, 1.0F).radians(), pi / 2.0F);
  EXPECT_EQ(core::atan2(-infinity, -1.0F).radians(), -pi / 2.0F);
  EXPECT_EQ(core::atan2(1.0F, infinity), Angle{});
  EXPECT_EQ(core::atan2(1.0F, -infinity).radians(), pi);
  EXPECT_TRUE(std::isnan(core::atan2(infinity, infinity).radians()));
  EXPECT_TRUE(std::isnan(core::atan2(not_a_number, 1.0F).radians()));
  EXPECT_TRUE(std::isnan(core::atan2(1.0F, not_a_number).radians()));
}

}  // namespace
}  // namespace fantail::core
