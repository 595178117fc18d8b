// SPDX-License-Identifier: MIT
#include "sim/wind.hpp"

#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr double degrees = std::numbers::pi / 180.0;

Wind wind(const WindParameters& parameters) { return Wind{parameters, Random{7, 1}}; }

TEST(Wind, BlowsFromWhereItComesFrom) {
  const Vector3 from_west = wind({.speed_m_s = 5.0, .from_rad = 270.0 * degrees}).step(0.0, 0.0, 10.0, 0.0);
  EXPECT_NEAR(from_west.x, 0.0, 1e-12);
  EXPECT_NEAR(from_west.y, -5.0, 1e-12);  // to the east, and y is west
  const Vector3 from_north = wind({.speed_m_s = 5.0}).step(0.0, 0.0, 10.0, 0.0);
  EXPECT_NEAR(from_north.x, -5.0, 1e-12);
  EXPECT_EQ(from_north.z, 0.0);
}

TEST(Wind, GrowsWithHeightAsAPowerLaw) {
  const Wind profile = wind({.speed_m_s = 5.0, .exponent = 1.0 / 7.0});
  for (const double height_m : {1.0, 10.0, 100.0, 1000.0}) {
    EXPECT_NEAR(profile.mean_m_s(height_m), 5.0 * std::pow(height_m / 10.0, 1.0 / 7.0), 1e-12);
  }
  EXPECT_GT(profile.mean_m_s(0.0), 0.0);
  EXPECT_EQ(wind({.speed_m_s = 5.0}).mean_m_s(1000.0), 5.0);
}

TEST(Wind, AGustRisesAndFallsAsACosine) {
  Wind gusty = wind({.speed_m_s = 3.0, .gust_m_s = 4.0, .gust_time_s = 2.0, .gust_duration_s = 1.0});
  double sum_m = 0.0;
  for (int i = 0; i < 4000; ++i) {
    sum_m += 1e-3 * -gusty.step(1e-3 * i, 1e-3, 10.0, 0.0).x;
  }
  EXPECT_NEAR(sum_m, 3.0 * 4.0 + 0.5 * 4.0 * 1.0, 1e-3);
  EXPECT_NEAR(gusty.step(2.5, 0.0, 10.0, 0.0).x, -7.0, 1e-12);
  EXPECT_NEAR(gusty.step(2.25, 0.0, 10.0, 0.0).x, -5.0, 1e-12);
  EXPECT_NEAR(gusty.step(3.0, 0.0, 10.0, 0.0).x, -3.0, 1e-12);
}

// The components at 100 m, over many scale lengths.
struct Statistics {
  std::array<double, 3> deviation{};
  std::array<double, 3> correlation{};  ///< over `lag` steps
};

Statistics statistics(double dt_s, std::size_t lag) {
  constexpr std::size_t samples = 400'000;
  Wind turbulent = wind({.speed_m_s = 10.0, .turbulence = 0.2});
  std::array<std::vector<double>, 3> all;
  for (std::size_t i = 0; i < samples; ++i) {
    const Vector3 now = turbulent.step(0.0, dt_s, 100.0, 50.0);
    all[0].push_back(-now.x - 10.0);
    all[1].push_back(now.y);
    all[2].push_back(now.z);
  }
  Statistics result;
  for (std::size_t c = 0; c < all.size(); ++c) {
    double square = 0.0;
    double product = 0.0;
    for (std::size_t i = 0; i + lag < samples; ++i) {
      square += all[c][i] * all[c][i];
      product += all[c][i] * all[c][i + lag];
    }
    result.deviation[c] = std::sqrt(square / static_cast<double>(samples - lag));
    result.correlation[c] = product / square;
  }
  return result;
}

// Scale lengths at 100 m (328 ft): 328 / (0.177 + 0.000823 328)^1.2 ft across, 328 ft upwards; passed at 50 m/s.
TEST(Wind, TurbulenceHasTheDeviationAndTheMemoryOfDryden) {
  const double base = 0.177 + 0.000823 * 100.0 / 0.3048;
  const double horizontal_s = 100.0 / std::pow(base, 1.2) / 50.0;
  const double vertical_s = 100.0 / 50.0;
  for (const double dt_s : {0.05, 0.5}) {  // exact for every step
    const std::size_t lag = dt_s < 0.1 ? 20 : 2;
    const double shift_s = dt_s * static_cast<double>(lag);
    const Statistics found = statistics(dt_s, lag);
    // 400 000 steps of 0.05 s hold about 4000 eddies: 2 % of the deviation are two of its own.
    EXPECT_NEAR(found.deviation[0], 2.0, 0.10) << dt_s;
    EXPECT_NEAR(found.deviation[1], 2.0, 0.10) << dt_s;
    EXPECT_NEAR(found.deviation[2], 2.0 * std::pow(base, 0.4), 0.10) << dt_s;
    // Of the transverse spectrum: (1 - t / 2T) exp(-t / T); of the longitudinal one: exp(-t / T).
    const double x = shift_s / horizontal_s;
    EXPECT_NEAR(found.correlation[0], (1.0 - 0.5 * x) * std::exp(-x), 0.03) << dt_s;
    EXPECT_NEAR(found.correlation[1], (1.0 - 0.5 * x) * std::exp(-x), 0.03) << dt_s;
    EXPECT_NEAR(found.correlation[2], std::exp(-shift_s / vertical_s), 0.03) << dt_s;
  }
}

TEST(Wind, IsTheSameForTheSameSeed) {
  Wind a{{.speed_m_s = 5.0, .turbulence = 0.1}, Random{3, 1}};
  Wind b{{.speed_m_s = 5.0, .turbulence = 0.1}, Random{3, 1}};
  Wind other{{.speed_m_s = 5.0, .turbulence = 0.1}, Random{4, 1}};
  const Vector3 first = a.step(0.0, 1e-3, 20.0, 30.0);
  EXPECT_EQ(first.x, b.step(0.0, 1e-3, 20.0, 30.0).x);
  EXPECT_NE(first.x, other.step(0.0, 1e-3, 20.0, 30.0).x);
}

}  // namespace
}  // namespace fantail::sim
