// SPDX-License-Identifier: MIT
#include "sim/wind_tunnel.hpp"

#include "gaussian.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

using test::Gaussian;

TEST(WindTunnel, StandsInSteadyStateAtTheFansSpeed) {
  WindTunnel tunnel{{}};
  EXPECT_DOUBLE_EQ(tunnel.speed_m_s(), 22.0);
  for (int i = 0; i < 10000; ++i) {
    ASSERT_DOUBLE_EQ(tunnel.step(0.001, 1.0), 22.0);
  }
  EXPECT_NEAR((WindTunnel{{.fan_rpm = 1700.0}}.speed_m_s()), 30.0, 0.1);
}

TEST(WindTunnel, FollowsANewSetPointWithAFirstOrderLag) {
  WindTunnel tunnel{{.fan_rpm = 1000.0, .speed_per_rpm_m_s = 0.02, .fan_lag_s = 4.0}};
  tunnel.set_fan_rpm(1500.0);
  EXPECT_DOUBLE_EQ(tunnel.speed_m_s(), 20.0);
  for (int i = 0; i < 4000; ++i) {
    tunnel.step(0.001, 0.0);
  }
  EXPECT_NEAR(tunnel.speed_m_s(), 30.0 - 10.0 * std::exp(-1.0), 1e-9);
  EXPECT_NEAR(tunnel.step(4.0, 0.0), 30.0 - 10.0 * std::exp(-2.0), 1e-9);  // one long step is as exact
  EXPECT_NEAR(tunnel.step(400.0, 0.0), 30.0, 1e-9);
}

TEST(WindTunnel, AGustDiesOutWithTheCorrelationTime) {
  WindTunnel tunnel{{.turbulence = 0.01, .turbulence_time_s = 0.25}, 2.0};
  EXPECT_DOUBLE_EQ(tunnel.speed_m_s(), 22.0 * 1.02);
  for (int i = 0; i < 250; ++i) {
    tunnel.step(0.001, 0.0);
  }
  EXPECT_NEAR(tunnel.speed_m_s(), 22.0 * (1.0 + 0.02 * std::exp(-1.0)), 1e-12);
  EXPECT_DOUBLE_EQ(tunnel.mean_speed_m_s(), 22.0);
}

// At steps of one hundredth, one fifth and twice the correlation time: an Euler step would fail the last two.
TEST(WindTunnel, TurbulenceHasItsStandardDeviationAndCorrelationAtEveryStepLength) {
  const std::uint64_t seed = 26;
  for (const double dt_s : {0.005, 0.1, 1.0}) {
    Gaussian gaussian{seed};
    WindTunnel tunnel{{.turbulence = 0.05, .turbulence_time_s = 0.5}, gaussian()};
    constexpr int count = 2000000;
    std::vector<double> gusts;
    gusts.reserve(count);
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
      gusts.push_back(tunnel.step(dt_s, gaussian()) / 22.0 - 1.0);
      sum += gusts.back();
    }
    const auto lag = static_cast<std::size_t>(std::max(1.0, std::round(0.5 / dt_s)));
    double variance = 0.0;
    double product = 0.0;
    for (std::size_t i = 0; i < gusts.size(); ++i) {
      variance += gusts[i] * gusts[i];
      product += i >= lag ? gusts[i] * gusts[i - lag] : 0.0;
    }
    // Samples one correlation time apart count as half independent; five standard errors.
    const double independent = count * std::min(1.0, dt_s);
    EXPECT_NEAR(sum / count, 0.0, 5.0 * 0.05 / std::sqrt(independent)) << "seed " << seed << " dt " << dt_s;
    EXPECT_NEAR(std::sqrt(variance / count), 0.05, 5.0 * 0.05 / std::sqrt(2.0 * independent))
        << "seed " << seed << " dt " << dt_s;
    EXPECT_NEAR(product / variance, std::exp(-static_cast<double>(lag) * dt_s / 0.5), 5.0 / std::sqrt(independent))
        << "seed " << seed << " dt " << dt_s;
  }
}

TEST(WindTunnel, SwirlIsAnEquivalentOffsetForTheDisturbance) {
  const WindTunnel tunnel{{.swirl_rad = -0.035, .density_kg_m3 = 1.15}};
  EXPECT_EQ(tunnel.swirl_rad(), -0.035);
  EXPECT_EQ(tunnel.density_kg_m3(), 1.15);
}

}  // namespace
}  // namespace fantail::sim
