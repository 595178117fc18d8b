// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "flown_world.hpp"
#include "input/shipped.hpp"

namespace fantail::sim {
namespace {

struct Rehearsal {
  const char* name;
  Device device;
  How how;
  std::size_t canard;  ///< as a person counts, 1 to 4
};

const std::vector<Rehearsal> rehearsals{
    {"bench_canard1_stuck", Device::servo, GearFault{ServoFault::stuck, 3.0 * degree}, 1},
    {"bench_canard1_dead", Device::servo, GearFault{ServoFault::dead}, 1},
    {"bench_canard2_slipping", Device::servo, GearFault{ServoFault::slipping}, 2},
    {"bench_canard2_encoder_unplugged", Device::encoder, Behaviour::dead, 2},
    {"bench_canard3_reversed", Device::servo, GearFault{ServoFault::reversed}, 3},
    {"bench_canard3_wrong_trim", Device::servo, GearFault{ServoFault::wrong_trim, 2.5 * degree}, 3},
    {"bench_canard4_slow", Device::servo, GearFault{ServoFault::slow}, 4},
    {"bench_canard4_encoder_noisy", Device::encoder, Noisy{60.0}, 4},
};

TEST(BenchScenarios, BreakOneCanardFromPowerUpAsTheirNamesSay) {
  for (const Rehearsal& rehearsal : rehearsals) {
    SCOPED_TRACE(rehearsal.name);
    const Scenario s = scenario(rehearsal.name);
    ASSERT_EQ(s.faults.size(), 1U);
    const Fault& fault = s.faults[0];
    EXPECT_EQ(fault.device, rehearsal.device);
    EXPECT_EQ(fault.how, rehearsal.how);
    EXPECT_EQ(fault.until_s, std::nullopt);
    EXPECT_EQ(fault.canard + 1, rehearsal.canard);
    EXPECT_LT(fault.from_s, -s.pad_time_s);
  }
}

TEST(BenchScenarios, AreTheHealthyOneButForTheFaultAndNoneIsForgottenHere) {
  const Scenario healthy = scenario("bench_healthy");
  EXPECT_TRUE(healthy.faults.empty());
  std::set<std::string> expected{"bench_healthy", "bench_axes"};  // the latter hangs in a gimbal, without a fault
  for (const Rehearsal& rehearsal : rehearsals) {
    SCOPED_TRACE(rehearsal.name);
    expected.insert(rehearsal.name);
    const Scenario s = scenario(rehearsal.name);
    EXPECT_EQ(s.vehicle_name, healthy.vehicle_name);
    EXPECT_EQ(s.plan_name, healthy.plan_name);
    EXPECT_EQ(s.seed, healthy.seed);
    ASSERT_EQ(s.disturbance.size(), 1U);
    EXPECT_EQ(s.disturbance[0].angle_rad, healthy.disturbance.at(0).angle_rad);
  }
  std::set<std::string> shipped;
  for (const std::string& name : input::shipped_names(input::Shipped::scenario)) {
    if (name.starts_with("bench_")) {
      shipped.insert(name);
    }
  }
  EXPECT_EQ(shipped, expected);
}

// The monitor of the flight must not take the spread of sound servos for a fault either.
TEST(BenchScenarios, TheHealthyRocketFliesWithHealthyCanardsForEverySeed) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Scenario s = scenario("bench_healthy");
    s.seed = seed;
    for (const Tick& tick : fly(s).ticks) {
      for (const core::CanardVerdict verdict : tick.record.verdicts) {
        ASSERT_EQ(verdict, core::CanardVerdict::healthy) << "seed " << seed << " at " << tick.time_s;
      }
    }
  }
}

}  // namespace
}  // namespace fantail::sim
