// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "predict/run.hpp"
#include "text/degrees.hpp"

namespace fantail::predict {
namespace {

using text::degrees;
using text::radians;

constexpr int draws = 40000;

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

template <typename ValueOf>
Moments moments(const sim::WindParameters& stated, const sim::WindSpread& spread, ValueOf value_of) {
  double sum = 0.0;
  double squares = 0.0;
  for (int seed = 0; seed < draws; ++seed) {
    const double value = value_of(drawn_wind(stated, spread, static_cast<std::uint64_t>(seed)));
    sum += value;
    squares += value * value;
  }
  return {sum / draws, std::sqrt(squares / draws - sum * sum / draws / draws)};
}

double speed(const sim::WindParameters& wind) { return wind.speed_m_s; }

TEST(DrawnWind, WithoutSpreadIsTheStatedOne) {
  const sim::WindParameters stated{.speed_m_s = 5.0, .from_rad = 1.0, .gust_m_s = 3.0, .turbulence = 0.1};
  const sim::WindParameters drawn = drawn_wind(stated, {}, 7);
  EXPECT_EQ(drawn.speed_m_s, 5.0);
  EXPECT_EQ(drawn.from_rad, 1.0);
  EXPECT_EQ(drawn.gust_m_s, 3.0);
  EXPECT_EQ(drawn.turbulence, 0.1);
}

TEST(DrawnWind, HasANormalSpeed) {
  const Moments found = moments({.speed_m_s = 8.0}, {.speed_m_s = 1.5}, speed);
  EXPECT_NEAR(found.mean, 8.0, 4.0 * 1.5 / std::sqrt(draws));
  EXPECT_NEAR(found.deviation, 1.5, 4.0 * 1.5 / std::sqrt(2.0 * draws));
}

// About zero, what is left of a normal distribution is one side of it: its mean is sqrt(2 / pi) of the deviation.
TEST(DrawnWind, IsCutAtZero) {
  const Moments found = moments({.speed_m_s = 0.0}, {.speed_m_s = 2.0}, speed);
  const double mean = 2.0 * std::sqrt(2.0 / std::numbers::pi);
  const double deviation = 2.0 * std::sqrt(1.0 - 2.0 / std::numbers::pi);
  EXPECT_NEAR(found.mean, mean, 4.0 * deviation / std::sqrt(draws));
  EXPECT_NEAR(found.deviation, deviation, 0.02);
}

TEST(DrawnWind, ComesFromAnywhereWithinTheSpreadAlike) {
  const sim::WindParameters stated{.speed_m_s = 5.0, .from_rad = radians(90.0)};
  const Moments found = moments(stated, {.direction_rad = radians(30.0)}, [](const sim::WindParameters& wind) {
    EXPECT_EQ(wind.speed_m_s, 5.0);
    EXPECT_GE(wind.from_rad, radians(60.0));
    EXPECT_LE(wind.from_rad, radians(120.0));
    return degrees(wind.from_rad);
  });
  EXPECT_NEAR(found.mean, 90.0, 0.4);
  EXPECT_NEAR(found.deviation, 30.0 / std::sqrt(3.0), 0.2);
}

TEST(DrawnWind, OfNoKnownDirectionComesFromEverywhereAlike) {
  const sim::WindParameters stated{.speed_m_s = 5.0, .from_rad = radians(350.0)};
  const sim::WindSpread unknown{.direction_rad = radians(180.0)};
  const Moments angle =
      moments(stated, unknown, [](const sim::WindParameters& wind) { return degrees(wind.from_rad); });
  EXPECT_NEAR(angle.mean, 180.0, 2.1);
  EXPECT_NEAR(angle.deviation, 360.0 / std::sqrt(12.0), 1.5);
  const Moments north =
      moments(stated, unknown, [](const sim::WindParameters& wind) { return std::cos(wind.from_rad); });
  EXPECT_NEAR(north.mean, 0.0, 0.015);
}

}  // namespace
}  // namespace fantail::predict
