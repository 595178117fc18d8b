// SPDX-License-Identifier: MIT
#include "flown_world.hpp"
#include "input/shipped.hpp"
#include "properties.hpp"

namespace fantail::sim {
namespace {

// Whatever a scenario may say, the run ends, and no truth is ever infinite or no number.
RC_GTEST_PROP(Scenario, AtTheEndsOfItsRangesFliesToAnEndWithFiniteNumbers, ()) {
  struct Corner {
    const char* key;
    std::vector<const char*> values;
  };
  static const std::vector<Corner> corners{
      {"body.mass_kg", {"0.4", "1000"}},
      {"body.drag_area_m2", {"0", "1"}},
      {"body.roll_inertia_kg_m2", {"1e-6", "0.9"}},
      {"aerodynamics.reference_area_m2", {"1e-8", "1"}},
      {"aerodynamics.damping_m2", {"0", "1e4"}},
      {"aerodynamics.torque_m", {"0", "1e4"}},
      {"aerodynamics.canard_stall_deg", {"5", "30"}},
      {"aerodynamics.canard_wash", {"0.3", "2"}},
      {"aerodynamics.canard_wash_distance_m", {"0", "30"}},
      {"aerodynamics.canard_hinge_moment_m3", {"-0.01", "0.01"}},
      {"servo.torque_n_m", {"0.005", "100"}},
      {"aerodynamics.compressibility", {"prandtl_glauert"}},
      {"environment.density", {"exponential", "isa", "constant"}},
      {"environment.density_kg_m3", {"0.01", "5"}},
      {"launch_guide.tilt_deg", {"0", "15"}},
      {"servo.lag_s", {"0.0005", "1"}},
      {"servo.delay_s", {"0", "0.05"}},
      {"servo.frame_rate_hz", {"40", "1000"}},
      {"servo.rate_limit_deg_s", {"1", "1e5"}},
      {"servo.stop_deg", {"1", "90"}},
      {"servo.backlash_deg", {"0", "5"}},
      {"servo.spread", {"0", "0.3"}},
      {"servo.centre_spread_deg", {"0", "1"}},
      {"servo.pulse_per_degree_us", {"-40", "-0.1", "0.1", "40"}},
      {"imu.full_scale_deg_s", {"50", "4000"}},
      {"imu.rate_noise_deg_s", {"0", "100"}},
      {"imu.full_scale_g", {"2", "400"}},
      {"imu.delay_s", {"0", "0.02"}},
      {"imu.misalignment_deg", {"0", "10"}},
      {"accelerometer.specific_force_noise_m_s2", {"0", "50"}},
      {"encoder.noise_counts", {"0", "1000"}},
      {"controller.proportional_gain", {"0", "10"}},
      {"controller.derivative_gain_s", {"0", "2"}},
      {"disturbance.angles_deg", {"[-45]", "[45]"}},
  };
  std::vector<std::string> changes{"aerodynamics.reference_area_range_m2=[]"};  // it holds for the file's area
  for (const Corner& corner : corners) {
    const auto pick = *rc::gen::inRange<std::size_t>(0, 2 * corner.values.size());
    if (pick < corner.values.size()) {
      changes.push_back(std::string{corner.key} + "=" + corner.values[pick]);
    }
  }
  const FlownWorld flown = fly("tasha3_launch2", changes);
  for (const Tick& tick : flown.ticks) {
    RC_ASSERT(std::isfinite(tick.truth.roll_angle_rad) && std::isfinite(tick.truth.roll_rate_rad_s));
    RC_ASSERT(std::isfinite(tick.truth.speed_m_s) && std::isfinite(tick.truth.height_m));
    RC_ASSERT(std::isfinite(tick.truth.canard_rad) && std::isfinite(tick.record.command.radians()));
  }
}

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
