// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "detection/event_models.hpp"
#include "detection/readings.hpp"
#include "detection/shapes.hpp"
#include "seed.hpp"
#include "sim/units.hpp"

namespace fantail::detection {
namespace {

/// The motion of one event.
class EventModel : public testing::Test {
 protected:
  const Motion& make(Kind kind, std::uint64_t event, bool all = true) {
    Streams streams = streams_of(seed_, kind, event);
    make_event(kind, streams, *motion_, all);
    return *motion_;
  }
  /// Speed along the axis after all of it, and the largest on the way.
  std::pair<double, double> speeds(const Motion& motion) const {
    double speed = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < motion.length; ++i) {
      speed += 1e-3 * static_cast<double>(motion.axial_m_s2[i]);
      largest = std::max(largest, std::abs(speed));
    }
    return {speed, largest};
  }

  std::uint32_t seed_ = test::seed(3);
  std::unique_ptr<Motion> motion_ = std::make_unique<Motion>();
};

TEST_F(EventModel, EveryKindFitsItsRoomAndIsFinite) {
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    for (std::uint64_t event = 0; event < 200; ++event) {
      const Motion& motion = make(static_cast<Kind>(kind), event);
      ASSERT_GE(motion.length, 1'000U);
      ASSERT_LE(motion.length, Motion::most);
      for (std::size_t i = 0; i < motion.length; ++i) {
        ASSERT_TRUE(std::isfinite(motion.axial_m_s2[i]) && std::isfinite(motion.across_m_s2[i]) &&
                    std::isfinite(motion.pitch_rate_rad_s[i]))
            << kind_table[kind].name << ' ' << event << " step " << i;
      }
    }
  }
}

TEST_F(EventModel, EveryEventBeginsAtRest) {
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    if (static_cast<Kind>(kind) == Kind::transport) {
      continue;  // nothing on a road is
    }
    for (std::uint64_t event = 0; event < 50; ++event) {
      const Motion& motion = make(static_cast<Kind>(kind), event);
      for (std::size_t i = 0; i + 2 < static_cast<std::size_t>(lead_s / 1e-3); ++i) {
        ASSERT_NEAR(motion.axial_m_s2[i], 0.0F, 1e-5F) << kind_table[kind].name << ' ' << event;
      }
    }
  }
}

TEST_F(EventModel, AnEventDependsOnSeedKindAndNumberAlone) {
  const auto axial = [this](std::uint64_t event) {
    const Motion& motion = make(Kind::shaking, event);
    return std::vector<float>{motion.axial_m_s2.begin(), motion.axial_m_s2.begin() + std::ptrdiff_t{3'000}};
  };
  const std::vector<float> first = axial(17);
  (void)make(Kind::drop, 3);
  EXPECT_EQ(first, axial(17));
  EXPECT_NE(first, axial(18));
}

TEST_F(EventModel, WithoutWhatIsAcrossTheAxisTheAxisIsTheSame) {
  const auto all = std::make_unique<Motion>();
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    for (std::uint64_t event = 0; event < 20; ++event) {
      *all = make(static_cast<Kind>(kind), event, true);
      const Motion& axial = make(static_cast<Kind>(kind), event, false);
      const auto length = static_cast<std::ptrdiff_t>(all->length);
      ASSERT_EQ(all->length, axial.length);
      ASSERT_TRUE(std::equal(all->axial_m_s2.begin(), all->axial_m_s2.begin() + length, axial.axial_m_s2.begin()) &&
                  std::equal(all->carried.begin(), all->carried.begin() + length, axial.carried.begin()) &&
                  std::equal(all->pitch_rate_rad_s.begin(), all->pitch_rate_rad_s.begin() + length,
                             axial.pitch_rate_rad_s.begin()))
          << kind_table[kind].name;
    }
  }
}

// What falls gains as much speed as the floor takes away and gives back: at the end it lies still.
TEST_F(EventModel, ADroppedRocketsShocksAreAsLargeAsItsFall) {
  for (std::uint64_t event = 0; event < 300; ++event) {
    const Motion& motion = make(Kind::drop, event);
    double speed = 0.0;  // upwards
    double fallen = 0.0;
    for (std::size_t i = 0; i < motion.length; ++i) {
      const double up_x = std::cos(motion.start_pitch_rad);
      const double up_z = std::sin(motion.start_pitch_rad);
      const double weight = (1.0 - static_cast<double>(motion.carried[i])) * g;
      speed += 1e-3 * (up_x * static_cast<double>(motion.axial_m_s2[i]) +
                       up_z * static_cast<double>(motion.across_m_s2[i]) - weight);
      fallen = std::min(fallen, speed);
    }
    EXPECT_GT(fallen, -std::sqrt(2.0 * g * 1.23)) << event;
    // A shock of two milliseconds is sampled twice, so its area is off by up to a fifth, and it changes the speed by
    // up to one and a half times that of the fall. The last bounce lifts it with less than 0.1 m/s.
    EXPECT_NEAR(speed, 0.0, 0.1 - 0.35 * fallen) << event;
  }
}

TEST_F(EventModel, NobodyShakesFurtherHarderOrMorePowerfullyThanArmsDo) {
  double hardest = 0.0;
  for (std::uint64_t event = 0; event < 300; ++event) {
    const Motion& motion = make(Kind::shaking, event);
    for (std::size_t i = 0; i < motion.length; ++i) {
      hardest = std::max(hardest, std::abs(static_cast<double>(motion.axial_m_s2[i])));
    }
    // 0.3 m at the frequency where the power's bound takes over, 600 W = 4 kg (2 pi f)^3 (0.3 m)^2 / 2.
    const double fastest = 0.3 * std::cbrt(1200.0 / (4.0 * 0.09));
    // From rest it swings to twice the speed's amplitude.
    EXPECT_LT(speeds(motion).second, 2.0 * 1.05 * fastest) << event;
  }
  EXPECT_LE(hardest, 300.0 / 4.0 * 1.0001);
  EXPECT_GT(hardest, 0.8 * 300.0 / 4.0);
}

// After the last landing it stands: thrust, free fall and shock add up to nothing.
TEST_F(EventModel, AChuffThrowsTheRocketNoHigherThanItsGuideAndItLandsAgain) {
  double highest = 0.0;
  for (std::uint64_t event = 0; event < 300; ++event) {
    const Motion& motion = make(Kind::chuff, event);
    double speed = 0.0;
    double height = 0.0;
    double rise = 0.0;
    for (std::size_t i = 0; i < 1'500; ++i) {
      speed += 1e-3 * static_cast<double>(motion.axial_m_s2[i]);
      height += 1e-3 * speed;
      rise = std::max(rise, height);
      if (height < 0.0 && speed < 0.0) {
        break;
      }
    }
    highest = std::max(highest, rise);
    EXPECT_LT(rise, 4.0) << event;  // 3.5 m and what vibration and rounding to a millisecond add
  }
  EXPECT_GT(highest, 3.0);
}

TEST_F(EventModel, ASwingingRailsRateIsWhatItsAccelerationAcrossFollowsFrom) {
  for (std::uint64_t event = 0; event < 50; ++event) {
    const Motion& motion = make(Kind::gust, event);
    double angle = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < motion.length; ++i) {
      angle += 1e-3 * static_cast<double>(motion.pitch_rate_rad_s[i]);
      largest = std::max(largest, std::abs(angle));
    }
    EXPECT_LT(largest, 5.1 * sim::radians_per_degree) << event;
  }
}

TEST(ConditionOfAnEvent, EverySecondHasBothWellAndTheOthersTakeTurns) {
  std::array<int, conditions> of{};
  for (std::uint64_t event = 0; event < 800; ++event) {
    ++of[static_cast<std::size_t>(condition_of(Kind::gust, event))];
  }
  EXPECT_EQ(of, (std::array<int, conditions>{400, 100, 100, 100, 100}));
  EXPECT_EQ(condition_of(Kind::launch, 7), Condition::well);
  EXPECT_NE(condition_of(Kind::launch_one_bad, 8), Condition::well);
}

TEST(ReadingsOfAnEvent, UpTurnsByTheAngleThatThePitchRateAddsUpTo) {
  const auto motion = std::make_unique<Motion>();
  const auto readings = std::make_unique<Readings>();
  motion->begin(1'000, 0.3);
  motion->turns = true;
  motion->pitch_rate_rad_s.fill(2.0F);
  sim::Random random{1, 1};
  begin_readings(Kind::bias, 0, *motion, random, *readings);
  finish_readings(*motion, random, *readings);
  EXPECT_NEAR(readings->up_x[500], std::cos(0.3 + 1.0), 1e-4);
  EXPECT_NEAR(readings->up_z[500], std::sin(0.3 + 1.0), 1e-4);
}

TEST(ReadingsOfAnEvent, AtTheEndsOfItsRangeAnAccelerometerSaysSo) {
  const auto motion = std::make_unique<Motion>();
  const auto readings = std::make_unique<Readings>();
  motion->begin(30, 0.0);
  motion->axial_m_s2[10] = 250.0F;   // beyond 16 g and below 32 g
  motion->axial_m_s2[20] = -250.0F;  // likewise downwards
  sim::Random random{1, 1};
  begin_readings(Kind::drop, 0, *motion, random, *readings);
  finish_readings(*motion, random, *readings);
  EXPECT_EQ(readings->quality[0][10], core::SampleQuality::saturated);
  EXPECT_EQ(readings->axial_m_s2[0][10], 16.0F * core::standard_gravity_m_s2);
  EXPECT_EQ(readings->quality[1][10], core::SampleQuality::valid);
  EXPECT_EQ(readings->quality[0][20], core::SampleQuality::invalid);
  EXPECT_EQ(readings->quality[0][0], core::SampleQuality::valid);
}

}  // namespace
}  // namespace fantail::detection
