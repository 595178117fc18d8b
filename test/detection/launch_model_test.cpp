// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "detection/event_models.hpp"
#include "seed.hpp"
#include "sim/units.hpp"

namespace fantail::detection {
namespace {

TEST(LaunchModel, TheWayIsTheTwiceIntegratedThrustLessTheWeightAlongTheGuide) {
  const std::uint32_t seed = test::seed(4);
  const auto motion = std::make_unique<Motion>();
  for (std::uint64_t event = 0; event < 100; ++event) {
    Streams streams = streams_of(seed, Kind::launch, event);
    make_launch(streams, *motion, 0.0, true);
    double speed = 0.0;
    double way = 0.0;
    for (std::size_t i = 0; i < motion->length; ++i) {
      ASSERT_NEAR(static_cast<double>(motion->distance_m[i]), way, 1e-3 + 1e-4 * way) << event << " step " << i;
      const double before = speed;
      speed +=
          1e-3 * (static_cast<double>(motion->thrust_m_s2[i]) - sim::gravity_m_s2 * std::cos(motion->start_pitch_rad));
      way += 0.5e-3 * (before + speed);
    }
    // 3 g in all its burn of at least a second: at least 2 g for what the rise leaves of it, less the drag.
    EXPECT_GT(way, 4.0) << event;
  }
}

TEST(LaunchModel, WithoutVibrationTheAxisFeelsTheThrustAlone) {
  const std::uint32_t seed = test::seed(5);
  const auto motion = std::make_unique<Motion>();
  Streams streams = streams_of(seed, Kind::launch, 1);
  make_launch(streams, *motion, 0.0, true);
  const double weight = sim::gravity_m_s2 * std::cos(motion->start_pitch_rad);
  for (std::size_t i = 0; i < motion->length; ++i) {
    EXPECT_NEAR(static_cast<double>(motion->axial_m_s2[i]) + static_cast<double>(motion->carried[i]) * weight,
                static_cast<double>(motion->thrust_m_s2[i]), 1e-4)
        << i;
  }
}

TEST(LaunchModel, TheThrustStandsAtThreeGOrMoreFromItsRiseOn) {
  const std::uint32_t seed = test::seed(6);
  const auto motion = std::make_unique<Motion>();
  double least_peak = 1e9;
  double largest_peak = 0.0;
  for (std::uint64_t event = 0; event < 400; ++event) {
    Streams streams = streams_of(seed, Kind::launch, event);
    make_launch(streams, *motion, 0.0, true);
    const auto end = motion->thrust_m_s2.begin() + static_cast<std::ptrdiff_t>(motion->length);
    const double peak = static_cast<double>(*std::max_element(motion->thrust_m_s2.begin(), end)) / sim::gravity_m_s2;
    least_peak = std::min(least_peak, peak);
    largest_peak = std::max(largest_peak, peak);
  }
  EXPECT_GT(least_peak, 2.9);
  EXPECT_LT(least_peak, 3.3);
  EXPECT_LT(largest_peak, 20.01);
  EXPECT_GT(largest_peak, 18.0);
}

}  // namespace
}  // namespace fantail::detection
