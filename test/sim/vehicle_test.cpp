// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "flown_world.hpp"

namespace fantail::sim {
namespace {

// The command is the same for all four, so what the encoders show apart from each other is the spread.
TEST(ServoSpread, MakesFourDifferentServosAndAnotherFourForAnotherSeed) {
  const auto centres_deg = [](const std::string& spread, std::uint64_t seed) {
    Scenario s = scenario("tasha3_launch2", {"servo.centre_spread_deg=" + spread, "encoder.noise_counts=0"});
    s.seed = seed;
    World world{s};
    const core::TickRecord& record = world.tick();
    std::array<double, 4> angles_deg{};
    for (std::size_t i = 0; i < angles_deg.size(); ++i) {
      angles_deg[i] = static_cast<double>(record.encoders[i]->radians()) / degree;
    }
    return angles_deg;
  };
  EXPECT_EQ(centres_deg("0", 1), (std::array<double, 4>{}));
  const std::array<double, 4> one = centres_deg("2", 1);
  const std::array<double, 4> other = centres_deg("2", 2);
  EXPECT_EQ(one, centres_deg("2", 1));
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_LE(std::abs(one[i]), 2.0 + 0.022);  // an encoder's count
    EXPECT_NE(one[i], other[i]);
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_NE(one[i], one[k]);
    }
  }
}

TEST(ServoSpread, HasAStreamOfItsOwnSoThatNoNoiseShifts) {
  const FlownWorld same = fly("tasha3_launch2");
  const FlownWorld spread = fly("tasha3_launch2", {"servo.spread=0.3"});
  EXPECT_NE(same.at(5.0).truth.canard_rad, spread.at(5.0).truth.canard_rad);
  for (std::size_t i = 0; i < 5'000; ++i) {  // on the pad
    ASSERT_EQ(same.ticks[i].record.motion.specific_force_m_s2.x, spread.ticks[i].record.motion.specific_force_m_s2.x);
    ASSERT_EQ(same.ticks[i].record.motion.roll_rate_rad_s, spread.ticks[i].record.motion.roll_rate_rad_s);
    ASSERT_EQ(same.ticks[i].record.encoders[3]->radians(), spread.ticks[i].record.encoders[3]->radians());
  }
}

}  // namespace
}  // namespace fantail::sim
