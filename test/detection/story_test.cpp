// SPDX-License-Identifier: MIT
// Flights that come down again, and rails that are raised, held against mechanics.
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "detection/event_models.hpp"
#include "detection/readings.hpp"
#include "detection/shapes.hpp"
#include "seed.hpp"
#include "sim/units.hpp"

namespace fantail::detection {
namespace {

class FlightThatComesDown : public testing::TestWithParam<Kind> {
 protected:
  const Motion& make(std::uint64_t event) {
    streams_ = streams_of(seed_, GetParam(), event);
    make_event(GetParam(), streams_, *motion_, true);
    return *motion_;
  }
  std::size_t begin(Part part) const { return motion_->part_begin[static_cast<std::size_t>(part)]; }
  double largest_carried(std::size_t first, std::size_t last) const {
    const auto from = motion_->carried.begin();
    return static_cast<double>(
        *std::max_element(from + static_cast<std::ptrdiff_t>(first), from + static_cast<std::ptrdiff_t>(last)));
  }

  std::uint32_t seed_ = test::seed(48);
  Streams streams_{streams_of(0, Kind::drop, 0)};
  std::unique_ptr<Motion> motion_ = std::make_unique<Motion>();
};

TEST_P(FlightThatComesDown, HasItsPartsInTheirOrderAndEndsWithTheCrew) {
  for (std::uint64_t event = 0; event < 300; ++event) {
    const Motion& motion = make(event);
    ASSERT_TRUE(std::is_sorted(motion.part_begin.begin(), motion.part_begin.end())) << event;
    ASSERT_LT(begin(Part::crew), motion.length) << event;
    ASSERT_LE(begin(Part::coast), motion.flight_end) << event;
    ASSERT_EQ(motion.part_of(0), Part::launch);
    ASSERT_EQ(motion.part_of(motion.length - 1), Part::crew);
  }
}

// Speed along the axis at burn-out, and without drag the height that it is good for: it leaves the guide, and it is no
// faster than the model says.
TEST_P(FlightThatComesDown, EveryFlightLeavesItsGuide) {
  for (std::uint64_t event = 0; event < 300; ++event) {
    const Motion& motion = make(event);
    double speed = 0.0;
    double way = 0.0;
    for (std::size_t i = 0; i < begin(Part::coast); ++i) {
      speed += 1e-3 * (static_cast<double>(motion.thrust_m_s2[i]) - g * std::cos(motion.start_pitch_rad));
      way += 1e-3 * speed;
    }
    ASSERT_GT(way + speed * speed / (2.0 * g), 4.0) << event;
    ASSERT_LT(speed, 71.0) << event;
  }
}

TEST_P(FlightThatComesDown, NothingCarriesItInItsCoastAndAParachuteDoesAfterwards) {
  std::size_t softest = 100;
  std::size_t hardest = 0;
  for (std::uint64_t event = 0; event < 300; ++event) {
    const Motion& motion = make(event);
    const std::size_t opening = begin(Part::drogue);
    ASSERT_EQ(motion.carried[opening - 1], 0.0F) << event;
    const double peak = largest_carried(opening, begin(Part::descent));
    ASSERT_GE(peak, 1.9) << event;  // the top of a half-sine of 50 ms is met within a millisecond
    ASSERT_LE(peak, 20.0001) << event;
    softest = std::min(softest, static_cast<std::size_t>(peak));
    hardest = std::max(hardest, static_cast<std::size_t>(peak));
    double carried = 0.0;
    for (std::size_t i = begin(Part::descent); i < begin(Part::main); ++i) {
      carried += static_cast<double>(motion.carried[i]);
    }
    // The weight, and up to five jolts of 2 g and 0.3 s within two seconds or more.
    EXPECT_NEAR(carried / static_cast<double>(begin(Part::main) - begin(Part::descent)), 1.4, 0.7) << event;
    EXPECT_GT(largest_carried(begin(Part::landing), begin(Part::lying)), 4.0) << event;
  }
  EXPECT_LE(softest, 3U);
  EXPECT_GE(hardest, 18U);
}

TEST_P(FlightThatComesDown, LiesStillBeforeTheCrewComes) {
  for (std::uint64_t event = 0; event < 300; ++event) {
    const Motion& motion = make(event);
    ASSERT_GE(begin(Part::crew) - begin(Part::lying), 1'000U);
    for (std::size_t i = begin(Part::lying); i < begin(Part::crew); ++i) {
      ASSERT_EQ(motion.carried[i], 1.0F) << event << " step " << i;
      ASSERT_EQ(motion.axial_m_s2[i], 0.0F) << event << " step " << i;
      ASSERT_EQ(motion.roll_rate_rad_s[i], 0.0F) << event << " step " << i;
      ASSERT_EQ(motion.pitch_rate_rad_s[i], 0.0F) << event << " step " << i;
    }
  }
}

// Whatever way it hangs, and however it spins: what an accelerometer feels is as long as what the parachute carries,
// and a gyro's rates across the axis are as long as the rate of the swing.
TEST_P(FlightThatComesDown, SpinningTurnsForcesAndRatesAndKeepsTheirSizes) {
  const auto readings = std::make_unique<Readings>();
  for (std::uint64_t event = 0; event < 20; event += 2) {
    const Motion& motion = make(event);
    begin_readings(GetParam(), event, motion, streams_.axial, *readings);
    finish_readings(motion, streams_.axial, *readings);
    InputMaker maker{motion, *readings, streams_.others};
    for (std::size_t i = 0; i < begin(Part::landing); ++i) {
      const core::Inputs& inputs = maker.step(i);
      if (i < begin(Part::descent)) {
        continue;
      }
      const core::Vector3 force = inputs.accelerometers[1 - motion.trouble.accelerometer].specific_force_m_s2;
      const double felt = std::sqrt(static_cast<double>(force.x * force.x + force.y * force.y + force.z * force.z));
      const double true_force = std::abs(static_cast<double>(motion.carried[i])) * g;
      // Zeros of up to 0.05 g on three axes, and noise of six standard deviations.
      ASSERT_NEAR(felt, std::min(true_force, 16.0 * g),
                  0.05 * g * 1.8 + 6.0 * 0.3 + (true_force > 15.0 * g ? 50.0 : 0.0))
          << event << " step " << i;
      const core::Vector3 rate = inputs.gyro.rate_rad_s;
      if (!motion.trouble.gyro_silent.has(i)) {
        ASSERT_NEAR(std::hypot(rate.y, rate.z), std::abs(motion.pitch_rate_rad_s[i]), 0.05) << event << " step " << i;
        ASSERT_NEAR(rate.x, motion.roll_rate_rad_s[i], 0.04) << event << " step " << i;
      }
    }
  }
}

// Every rocket hangs somehow, and the first opening comes at every angle of the axis.
TEST_P(FlightThatComesDown, TheFirstOpeningComesNoseUpAcrossAndNoseDown) {
  const auto readings = std::make_unique<Readings>();
  std::set<int> sixths;
  for (std::uint64_t event = 0; event < 100; ++event) {
    const Motion& motion = make(event);
    begin_readings(GetParam(), event, motion, streams_.axial, *readings);
    const double up = static_cast<double>(readings->up_x[begin(Part::drogue)]);
    sixths.insert(static_cast<int>(std::acos(std::clamp(up, -1.0, 1.0)) / (30.0 * sim::radians_per_degree)));
  }
  EXPECT_EQ(sixths.size(), 6U);
}

INSTANTIATE_TEST_SUITE_P(Flights, FlightThatComesDown, testing::Values(Kind::missed_flight, Kind::uncontrolled_flight),
                         [](const auto& kind) { return std::string{kind_table[index(kind.param)].name}; });

TEST(RaisedRail, StandsStillAtItsLastAngleUntilTheLaunch) {
  const std::uint32_t seed = test::seed(49);
  const auto motion = std::make_unique<Motion>();
  const auto readings = std::make_unique<Readings>();
  double shortest_s = 10.0;
  double longest_s = 0.0;
  for (std::uint64_t event = 0; event < 300; ++event) {
    Streams streams = streams_of(seed, Kind::raised_rail, event);
    make_raised_rail(streams, *motion, true);
    begin_readings(Kind::raised_rail, event, *motion, streams.axial, *readings);
    double raised = 0.0;
    for (std::size_t i = 0; i < motion->ignition; ++i) {
      raised -= 1e-3 * static_cast<double>(motion->pitch_rate_rad_s[i]) / sim::radians_per_degree;
      if (i > motion->still_from) {
        ASSERT_EQ(motion->pitch_rate_rad_s[i], 0.0F) << event;
        ASSERT_NEAR(motion->axial_m_s2[i], 0.0F, 1e-5F) << event;
      }
    }
    ASSERT_GT(raised, 4.9) << event;
    ASSERT_LT(raised, 90.1) << event;
    // On the rail the axis feels its share of the weight at the last angle, which the guide's axis has, too.
    const double pitch = motion->start_pitch_rad - raised * sim::radians_per_degree;
    ASSERT_NEAR(static_cast<double>(readings->felt_m_s2[motion->ignition - 1]), g * std::cos(pitch), 0.05) << event;
    ASSERT_LT(pitch, 15.1 * sim::radians_per_degree) << event;
    const double still_s = 1e-3 * static_cast<double>(motion->ignition - motion->still_from);
    shortest_s = std::min(shortest_s, still_s);
    longest_s = std::max(longest_s, still_s);
  }
  EXPECT_LT(shortest_s, 0.6);
  EXPECT_GT(longest_s, 9.5);
}

TEST(StirredLaunch, StandsStillBetweenTheDisturbanceAndIgnition) {
  const std::uint32_t seed = test::seed(50);
  const auto motion = std::make_unique<Motion>();
  const auto readings = std::make_unique<Readings>();
  double loudest = 0.0;
  for (std::uint64_t event = 0; event < 200; ++event) {
    Streams streams = streams_of(seed, Kind::stirred_launch, event);
    make_event(Kind::stirred_launch, streams, *motion, true);
    begin_readings(Kind::stirred_launch, event, *motion, streams.axial, *readings);
    ASSERT_LE(motion->ignition, 3'500U);
    ASSERT_GE(motion->ignition, 2'000U);
    ASSERT_NEAR(motion->axial_m_s2[motion->ignition - 1], 0.0F, 1e-5F) << event;
    // It stands as the rail leans, and on its last way the thrust alone is felt along the axis.
    ASSERT_NEAR(readings->felt_m_s2[motion->ignition - 1], 9.80665F * readings->up_x[motion->ignition - 1], 1e-3)
        << event;
    for (std::size_t i = 0; i < motion->ignition; ++i) {
      loudest = std::max(loudest, std::abs(static_cast<double>(motion->axial_m_s2[i])));
    }
  }
  EXPECT_GT(loudest, 2.0 * g);
}

}  // namespace
}  // namespace fantail::detection
