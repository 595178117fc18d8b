// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "tunnel/made_logs.hpp"
#include "tunnel/statistics.hpp"

namespace fantail::tunnel {
namespace {

/// 20 m/s, from 100 s on 30 m/s; every other reading is as much above it as the next is below: a deviation of that
/// share, but for the sample's number less one.
TunnelLog alternating(double share, const std::function<double(double)>& shown) {
  return made_tunnel_log(
      200.0, [](double t) { return t < 100.0 ? 1000.0 : 1500.0; },
      [&](double t) {
        const double sign = std::fmod(t, 4.0) < 1.0 ? 1.0 : -1.0;
        return shown((t < 100.0 ? 20.0 : 30.0) * (1.0 + sign * share));
      });
}

const auto as_it_is = [](double value) { return value; };

TEST(Unsteadiness, IsThatOfTheWholeSetPointAlsoWhereASwingSawTwoReadings) {
  const TunnelLog log = alternating(0.03, as_it_is);
  const SteadySegments steady = find_steady(log, {});
  ASSERT_EQ(steady.found.size(), 2U);
  for (const double begin_s : {40.0, 150.0}) {
    EXPECT_NEAR(unsteadiness(log, steady, begin_s, begin_s + 3.0).value().share, 0.03, 0.001);
  }
}

TEST(Unsteadiness, OfASensorThatRoundsIsNotItsRounding) {
  // To half metres per second: 0.144 m/s of scatter by itself, which is 0.72 % of 20 m/s.
  Gaussian gaussian{7};
  const TunnelLog rounded = made_tunnel_log(
      8000.0, [](double) { return 1000.0; }, [&](double) { return 0.5 * std::round(2.0 * (20.0 + 0.4 * gaussian())); });
  const Unsteadiness air = unsteadiness(rounded, {}, 0.0, 8000.0).value();
  EXPECT_NEAR(air.rounding_share, 0.00722, 5e-5);
  EXPECT_NEAR(air.share, 0.02, 0.001);
  const Unsteadiness still = unsteadiness(alternating(0.0, as_it_is), {}, 0.0, 98.0).value();
  EXPECT_EQ(still.share, 0.0);
}

TEST(Unsteadiness, IsNotKnownFromFewReadingsAndWithoutWind) {
  const TunnelLog log = alternating(0.03, as_it_is);
  EXPECT_FALSE(unsteadiness(log, {}, 10.0, 17.0));  // 10, 12, 14, 16 s
  EXPECT_TRUE(unsteadiness(log, {}, 10.0, 18.0));
  EXPECT_FALSE(unsteadiness(alternating(0.03, [](double) { return 0.0; }), {}, 0.0, 98.0));
}

}  // namespace
}  // namespace fantail::tunnel
