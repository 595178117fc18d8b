// SPDX-License-Identifier: MIT
#include "sim/world.hpp"

#include "flown_world.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

using core::Phase;

const std::vector<std::string> calm_tunnel{"disturbance.angles_deg=[0]", "tunnel.swirl_deg=0", "reference.kind=hold",
                                           "run.control_time_s=6"};

std::vector<std::string> with(std::vector<std::string> changes, const std::vector<std::string>& more) {
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}

// The project's sign convention, in one line from the reference to the truth: a positive reference asks for a positive
// command, all four canards turn positive, the rocket rolls positive, and the estimator says so too.
TEST(World, PositiveCommandTurnsCanardsTruthAndEstimatePositive) {
  const FlownWorld flown = fly("tunnel_steps", with(calm_tunnel, {"reference.initial_deg=20"}));
  const Tick& start = flown.at(0.0);
  EXPECT_EQ(start.record.phase, Phase::controlling);
  EXPECT_NEAR(static_cast<double>(start.record.command.radians()), 9.0 * degree,
              1e-6);  // kp 20 deg = 10 deg, at the limit of 9
  const Tick& soon = flown.at(0.2);
  EXPECT_GT(soon.truth.canard_rad, 1.0 * degree);
  EXPECT_GT(soon.truth.roll_rate_rad_s, 5.0 * degree);
  EXPECT_GT(soon.truth.roll_angle_rad, 0.5 * degree);
  EXPECT_NEAR(static_cast<double>(soon.record.motion.roll_rate_rad_s), soon.truth.roll_rate_rad_s, 1.0 * degree);
  EXPECT_NEAR(static_cast<double>(soon.record.motion.roll_angle.radians()), soon.truth.roll_angle_rad, 0.2 * degree);
  for (const auto& encoder : soon.record.encoders) {
    ASSERT_TRUE(encoder.has_value());
    EXPECT_GT(static_cast<double>(encoder->radians()), 1.0 * degree);
  }
}

TEST(World, ADisturbanceIsAnsweredByTheOppositeCommandUntilTheyBalance) {
  for (const double disturbance_deg : {-3.0, 2.0}) {
    const FlownWorld flown =
        fly("tunnel_steps", with(calm_tunnel, {"disturbance.angles_deg=[" + std::to_string(disturbance_deg) + "]"}));
    const Tick& settled = flown.at(5.0);
    EXPECT_NEAR(settled.truth.disturbance_rad, disturbance_deg * degree, 1e-12);
    EXPECT_NEAR(static_cast<double>(settled.record.command.radians()), -disturbance_deg * degree, 0.2 * degree);
    EXPECT_NEAR(settled.truth.roll_angle_rad, disturbance_deg * degree / 0.5, 0.4 * degree);  // u_d / kp
    EXPECT_LT(flown.at(0.1).truth.roll_rate_rad_s * disturbance_deg * -1.0, 0.0) << "rolls the way it is pushed";
  }
}

struct Lean {
  double tilt_deg;
  double spin_deg_s;
};

class GuideClearance : public testing::TestWithParam<Lean> {};

// 4 m of guide and 2 m more, measured along the guide however it leans and however the rocket turns in it. A tick at
// 16 m/s is 1.6 cm; the rest is sensor noise, integrated twice.
TEST_P(GuideClearance, IsFoundWithinCentimetresOfSixMetres) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Scenario s = scenario("tasha3_launch2", {"launch_guide.tilt_deg=" + std::to_string(GetParam().tilt_deg)});
    s.seed = seed;
    s.imposed_roll = {.time_s = 0.0, .angle_rad = 0.0, .rate_rad_s = GetParam().spin_deg_s * degree};
    const FlownWorld flown = fly(s);
    const Tick* start = flown.first_in(Phase::controlling);
    ASSERT_NE(start, nullptr);
    EXPECT_NEAR(start->truth.height_m / std::cos(GetParam().tilt_deg * degree), 6.0, 0.08) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Leaning, GuideClearance,
                         testing::Values(Lean{0, 0}, Lean{5, 0}, Lean{10, 200}, Lean{15, 0}, Lean{15, 360},
                                         Lean{15, -360}),
                         [](const auto& one) { return "Number" + std::to_string(one.index); });

// Thrust rises by 3200 N/s; the rocket is off when it carries its weight: 3.99 kg at 12.2 ms, so at the next tick.
TEST(World, TimeZeroIsTheFirstTickWithNetUpwardAcceleration) {
  const FlownWorld flown = fly("tasha3_launch2");
  ASSERT_TRUE(flown.events.liftoff);
  EXPECT_EQ(*flown.events.liftoff, core::Microseconds{10'013'000});
  EXPECT_EQ(flown.at(0.0).truth.speed_m_s, 0.0);
  EXPECT_GT(flown.at(0.001).truth.speed_m_s, 0.0);
}

TEST(World, EventsComeInTheOrderOfAFlightAndTheRunEndsAfterTheLast) {
  for (const char* name : {"tasha3_launch1", "tasha3_launch2"}) {
    const FlownWorld flown = fly(name);
    const World::Events& e = flown.events;
    ASSERT_TRUE(e.liftoff && e.guide_clear && e.burnout && e.apogee);
    EXPECT_LT(*e.liftoff, *e.guide_clear);
    EXPECT_LT(*e.guide_clear, *e.burnout);
    EXPECT_LT(*e.burnout, *e.apogee);
    EXPECT_EQ(flown.ticks.back().record.time, *e.apogee + core::Microseconds{999'000});
    Phase before = Phase::safe;
    for (const Tick& tick : flown.ticks) {
      EXPECT_GE(tick.record.phase, before);
      before = tick.record.phase;
    }
    EXPECT_EQ(before, Phase::finished);
    for (std::size_t i = 1; i < flown.ticks.size(); ++i) {
      ASSERT_EQ(flown.ticks[i].record.time - flown.ticks[i - 1].record.time, core::Microseconds{1000});
    }
  }
}

TEST(World, TheSameSeedGivesTheSameTicksAndAnotherOthers) {
  Scenario s = scenario("tasha3_launch2");
  const FlownWorld first = fly(s);
  const FlownWorld again = fly(s);
  ASSERT_EQ(first.ticks.size(), again.ticks.size());
  for (std::size_t i = 0; i < first.ticks.size(); ++i) {
    ASSERT_EQ(first.ticks[i].truth.roll_angle_rad, again.ticks[i].truth.roll_angle_rad);
    ASSERT_EQ(first.ticks[i].record.motion.specific_force_m_s2.x, again.ticks[i].record.motion.specific_force_m_s2.x);
    ASSERT_EQ(first.ticks[i].record.command, again.ticks[i].record.command);
  }
  s.seed = 2;
  const FlownWorld other = fly(s);
  EXPECT_NE(first.at(5.0).truth.roll_angle_rad, other.at(5.0).truth.roll_angle_rad);
  EXPECT_NE(first.at(-1.0).record.motion.specific_force_m_s2.x, other.at(-1.0).record.motion.specific_force_m_s2.x);
}

TEST(World, RollIsImposedExactlyOnce) {
  const FlownWorld flown = fly("tasha3_launch1");
  int times = 0;
  for (const Tick& tick : flown.ticks) {
    times += tick.truth.roll_angle_rad == -0.6 * degree && tick.truth.roll_rate_rad_s == 51.8 * degree ? 1 : 0;
  }
  EXPECT_EQ(times, 1);
  EXPECT_EQ(flown.at(0.21).truth.roll_rate_rad_s, 51.8 * degree);
  EXPECT_LT(std::abs(flown.at(0.209).truth.roll_rate_rad_s), 5.0 * degree);
  EXPECT_NEAR(flown.at(0.211).truth.roll_rate_rad_s, 51.8 * degree, 1.0 * degree);
}

TEST(World, ARocketTooHeavyForItsMotorStaysAndTheRunEndsAfterBurnOut) {
  const FlownWorld flown = fly("tasha3_launch2", {"body.mass_kg=100"});
  EXPECT_FALSE(flown.events.liftoff || flown.events.apogee || flown.events.guide_clear);
  ASSERT_TRUE(flown.events.burnout);
  EXPECT_EQ(flown.ticks.back().record.time, *flown.events.burnout + core::Microseconds{999'000});
  EXPECT_EQ(flown.ticks.back().record.phase, Phase::armed);
  for (const Tick& tick : flown.ticks) {
    ASSERT_EQ(tick.truth.height_m, 0.0);
    ASSERT_EQ(tick.truth.roll_angle_rad, 0.0);
  }
}

// A motor that coughs lets the rocket hop a centimetre and stand again; the flight, if there is one, is still to come.
TEST(World, AHopOnThePadIsNotTheApogee) {
  Scenario s = scenario("tasha3_launch2");
  const std::vector<ThrustPoint> cough{{0, 0}, {0.02, 150}, {0.05, 10}, {0.6, 10}, {0.7, 160}, {2.5, 160}, {2.6, 0}};
  s.vehicle.motor = ThrustCurve{cough, 0.2};
  const FlownWorld flown = fly(s);
  ASSERT_TRUE(flown.events.apogee);
  EXPECT_GT(flown.ticks.back().truth.height_m, 50.0);
  EXPECT_GT(*flown.events.apogee, *flown.events.burnout);

  s.vehicle.motor = ThrustCurve{{{0, 0}, {0.02, 150}, {0.05, 10}, {3, 0}}, 0.2};
  const FlownWorld only_a_hop = fly(s);
  EXPECT_LE(only_a_hop.ticks.back().record.time, *only_a_hop.events.burnout + core::Microseconds{1'000'000});
}

// Two pushes of a weak motor with a pause, alone and with a third rocket's weight: whoever looks longer sees the same.
TEST(World, EventsDoNotDependOnHowLongOneLooks) {
  const std::vector<ThrustPoint> pauses{{0, 0}, {0.02, 160}, {1, 160}, {1.02, 0},
                                        {6, 0}, {6.02, 180}, {9, 180}, {9.02, 0}};
  for (const char* motion : {"straight", "six_dof"}) {
    for (const double mass_kg : {2.5, 3.99, 8.0}) {
      Scenario s = scenario("tasha3_launch2", {std::string{"flight.motion="} + motion});
      s.vehicle.mass_kg = mass_kg;
      s.vehicle.motor = ThrustCurve{pauses, 0.2};
      s.time_after_end_s = 60.0;
      const FlownWorld longest = fly(s);
      const auto highest = std::ranges::max_element(longest.ticks, {}, [](const Tick& t) { return t.truth.height_m; });
      ASSERT_TRUE(longest.events.apogee && longest.events.burnout) << motion << mass_kg;
      EXPECT_NEAR(core::seconds(*longest.events.apogee - highest->record.time), 0.001, 0.0011) << motion << mass_kg;
      for (const double looked_s : {0.0, 1.0, 8.0}) {
        s.time_after_end_s = looked_s;
        const FlownWorld flown = fly(s);
        EXPECT_EQ(flown.events.liftoff, longest.events.liftoff) << motion << mass_kg << ' ' << looked_s;
        EXPECT_EQ(flown.events.guide_clear, longest.events.guide_clear) << motion << mass_kg << ' ' << looked_s;
        EXPECT_EQ(flown.events.burnout, longest.events.burnout) << motion << mass_kg << ' ' << looked_s;
        EXPECT_EQ(flown.events.apogee, longest.events.apogee) << motion << mass_kg << ' ' << looked_s;
      }
    }
  }
}

TEST(World, AParachuteOpensHoweverShortOneLooks) {
  for (const double looked_s : {0.0, 1.0, 30.0}) {
    const FlownWorld flown =
        fly("tasha3_launch2", {"flight.motion=six_dof", "recovery.drag_area_m2=0.8", "recovery.delay_s=4",
                               "timing.time_after_end_s=" + std::to_string(looked_s)});
    ASSERT_TRUE(flown.events.parachute) << looked_s;
    EXPECT_NEAR(core::seconds(*flown.events.parachute - *flown.events.apogee), 4.0, 0.0021) << looked_s;
  }
  // It falls to the ground in less than a minute.
  const FlownWorld late = fly("tasha3_launch2", {"flight.motion=six_dof", "recovery.delay_s=60"});
  EXPECT_FALSE(late.events.parachute);
  EXPECT_EQ(late.ticks.back().truth.height_m, 0.0);
}

TEST(World, AStartCommandThatIsRefusedEndsTheRun) {
  const FlownWorld flown = fly("tunnel_steps", {"timing.pad_time_s=1", "timing.arm_time_s=0.95"});
  EXPECT_FALSE(flown.events.liftoff);
  EXPECT_EQ(flown.first_in(Phase::controlling), nullptr);
  EXPECT_LE(flown.ticks.size(), 3'100U);
}

}  // namespace
}  // namespace fantail::sim
