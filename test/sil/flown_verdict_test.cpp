// SPDX-License-Identifier: MIT
// Verdicts on flights that once misled: what the report says of a simulated flight, against the truth of the world.

#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "report/verdict.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

using report::Outcome;

struct Judged {
  flight::Flight flight;
  report::Figures figures;
  report::Verdict verdict;
  [[nodiscard]] bool says(const std::string& words) const { return verdict.text.find(words) != std::string::npos; }
  [[nodiscard]] bool notes(const std::string& words) const {
    return std::ranges::any_of(flight.notes, [&](const auto& note) { return note.find(words) != std::string::npos; });
  }
};

Judged fly(const sim::Scenario& scenario) {
  Judged judged{.flight = fly::fly_scenario(scenario), .figures = {}, .verdict = {}};
  judged.figures = report::figures(judged.flight);
  judged.verdict = report::verdict(judged.flight, judged.figures);
  return judged;
}

sim::Scenario launch2(const std::vector<std::string>& changes = {}) {
  return input::load_scenario("tasha3_launch2", input::parse_overrides(changes));
}

// All trims at 3 degrees: the canards deflect by -12 to +6. The offset wants -7 first and +6.5 later.
TEST(FlownVerdict, AnOffsetThatChangesItsSenseIsHeldAgainstBothEndsOfTheCanards) {
  sim::Scenario scenario =
      launch2({"reference.kind=hold", "excitation.form=none", "canard_mounting.trim_deg=[3,3,3,3]"});
  for (const double sign : {1.0, -1.0}) {
    for (sim::CanardMounting& canard : scenario.vehicle.canards) {
      canard.trim_rad = sign * text::radians(3.0);
    }
    const auto node = [&](double time_s, double angle_deg) {
      return sim::DisturbanceNode{.time_s = time_s, .angle_rad = sign * text::radians(angle_deg)};
    };
    scenario.disturbance = {node(0, 7), node(2, 7), node(4, -6.5), node(6, -6.5)};
    const Judged flown = fly(scenario);
    EXPECT_NEAR(text::degrees(*flown.figures.authority_margin_rad), -0.5, 1e-6) << sign;
    EXPECT_EQ(flown.verdict.outcome, Outcome::not_held) << flown.verdict.text;
  }
}

// The servos' centres are off by up to 1 degree, drawn from the seed: the world's own draw counts.
TEST(FlownVerdict, AuthorityKnowsHowTheServosWereBuilt) {
  sim::Scenario scenario = launch2(
      {"servo.centre_spread_deg=1", "reference.kind=hold", "excitation.form=none", "disturbance.angles_deg=[-15]"});
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    scenario.seed = seed;
    const Judged flown = fly(scenario);
    const double reached_deg = text::degrees(flown.flight.canard_reach->highest_rad);
    EXPECT_NE(reached_deg, 9.0);
    double most_deg = 0.0;
    for (const flight::Row& row : flown.flight.rows) {
      most_deg = std::max(most_deg, text::degrees(row.truth->canard_rad));
    }
    EXPECT_NEAR(most_deg, reached_deg, 0.06) << seed;  // half the play of the gear
  }
}

// Two canards at their stop of 25 degrees: all together deflect by 8 to 17 and cannot come back to the 2 that are
// wanted.
TEST(FlownVerdict, CanardsThatCannotComeBackFarEnoughHaveNoAuthority) {
  sim::Scenario scenario = launch2();
  scenario.disturbance = {{.time_s = 0.0, .angle_rad = text::radians(-2.0)}};
  for (const std::size_t canard : {0U, 1U}) {
    scenario.faults.push_back(
        {.device = sim::Device::servo, .canard = canard, .how = sim::GearFault{sim::ServoFault::hardover}});
  }
  const Judged flown = fly(scenario);
  EXPECT_LT(*flown.figures.authority_margin_rad, 0.0) << flown.verdict.text;
  EXPECT_EQ(flown.verdict.outcome, Outcome::not_held);
  EXPECT_TRUE(
      flown.says("canards 1, 2 do not follow their commands, and the fin offset of -2.0 deg is, with that, beyond "
                 "what they can balance"))
      << flown.verdict.text;
}

TEST(FlownVerdict, WhereACanardStandsAtItsStopTheFinOffsetIsNotBlamedAlone) {
  sim::Scenario scenario = launch2();
  scenario.faults.push_back(
      {.device = sim::Device::servo, .how = sim::GearFault{sim::ServoFault::stuck, -scenario.vehicle.servo.stop_rad}});
  const Judged flown = fly(scenario);
  EXPECT_EQ(flown.verdict.outcome, Outcome::not_held);
  EXPECT_TRUE(flown.says("canard 1 does not follow its command, and the fin offset of -4.9 deg is, with that, beyond"))
      << flown.verdict.text;
  EXPECT_FALSE(flown.says("4.9 deg is beyond what")) << flown.verdict.text;
}

// 850 N for half a second, 22 g: as much impulse as the usual motor.
sim::Scenario strong_motor(double second_range_g) {
  sim::Scenario scenario = launch2();
  scenario.vehicle.motor = sim::ThrustCurve{{{0.0, 0.0}, {0.01, 850.0}, {0.54, 850.0}, {0.55, 0.0}}, 0.124};
  scenario.vehicle.accelerometer.full_scale_m_s2 = second_range_g * sim::gravity_m_s2;
  return scenario;
}

TEST(FlownVerdict, AMotorBeyondTheRangeOfOneAccelerometerIsFlownByTheOther) {
  const Judged flown = fly(strong_motor(32.0));
  EXPECT_EQ(flown.verdict.outcome, Outcome::held) << flown.verdict.text;
  EXPECT_NEAR(*flown.figures.ended_before_apogee_s, 0.0, 0.1);
  EXPECT_FALSE(flown.says("lower bounds"));
  EXPECT_TRUE(flown.notes("The motor pushes with")) << "beyond the range of the IMU";
}

TEST(FlownVerdict, AMotorBeyondTheRangeOfBothIsNotFlownToAnImaginedApogee) {
  const Judged flown = fly(strong_motor(16.0));
  EXPECT_LT(*flown.figures.ended_before_apogee_s, 0.5) << flown.verdict.text;
  EXPECT_TRUE(flown.says("knew only lower bounds of height and speed"));
}

TEST(FlownVerdict, AnOutageOfSevenMillisecondsNeitherEndsControlNorGoesUnsaid) {
  sim::Scenario scenario = launch2();
  scenario.faults = {{.device = sim::Device::imu, .how = sim::Behaviour::hangs, .from_s = 3.0, .until_s = 3.007}};
  const Judged flown = fly(scenario);
  EXPECT_EQ(flown.verdict.outcome, Outcome::held);
  EXPECT_TRUE(flown.says("The gyro gave no usable rate for 0.006 s in all, first at 2.99 s")) << flown.verdict.text;
}

TEST(FlownVerdict, ControlThatADeadGyroEndedIsJudgedUpToApogee) {
  sim::Scenario scenario = launch2();
  scenario.faults = {{.device = sim::Device::imu, .how = sim::Behaviour::hangs, .from_s = 3.0, .until_s = 20.0}};
  const Judged flown = fly(scenario);
  EXPECT_EQ(flown.verdict.outcome, Outcome::not_held);
  EXPECT_TRUE(
      flown.says("Control ended at 3.24 s, 7.12 s before apogee: the gyro failed. After that the rocket turned"))
      << flown.verdict.text;
  EXPECT_GT(text::degrees(*flown.figures.roll_after_end_rad), 360.0);
}

TEST(FlownVerdict, ALimitCycleIsNotCalledHeld) {
  const std::vector<std::string> gains{"controller.proportional_gain=10", "controller.derivative_gain_s=2"};
  const Judged excited = fly(launch2(gains));
  EXPECT_EQ(excited.verdict.outcome, Outcome::oscillates) << excited.verdict.text;
  EXPECT_TRUE(excited.says("The loop is unstable"));
  std::vector<std::string> quiet = gains;
  quiet.emplace_back("excitation.form=none");
  const Judged unexcited = fly(launch2(quiet));
  EXPECT_EQ(unexcited.verdict.outcome, Outcome::oscillates);
  EXPECT_TRUE(unexcited.says("The canards oscillate at")) << unexcited.verdict.text;
}

TEST(FlownVerdict, TheShippedLaunchIsStableAtEverySpeed) {
  const Judged flown = fly(launch2());
  ASSERT_GE(flown.flight.loop_margins.size(), 3U);
  for (const flight::LoopMargin& margin : flown.flight.loop_margins) {
    EXPECT_GT(text::degrees(margin.phase_margin_rad), 45.0);
  }
  EXPECT_FALSE(flown.figures.oscillation);
}

TEST(FlownVerdict, TheAuthorityMarginKnowsTheStopOfTheServo) {
  const Judged flown = fly(launch2({"servo.stop_deg=4.5"}));
  EXPECT_NEAR(text::degrees(*flown.figures.authority_margin_rad), 4.5 - 4.9, 1e-6);
  EXPECT_EQ(flown.verdict.outcome, Outcome::not_held);
}

// Fins so crooked that the rocket turns faster than any gyro can measure.
TEST(FlownVerdict, ASpinBeyondTheGyroIsNamedWithItsSense) {
  for (const double offset_deg : {-30.0, 30.0}) {
    sim::Scenario scenario = launch2();
    scenario.disturbance = {{.time_s = 0.0, .angle_rad = text::radians(offset_deg)}};
    scenario.vehicle.imu.full_scale_rad_s = text::radians(500.0);
    const Judged flown = fly(scenario);
    EXPECT_EQ(flown.verdict.outcome, Outcome::not_held);
    EXPECT_TRUE(flown.says(offset_deg > 0.0 ? "gyro's range of 500 deg/s, positively" : "500 deg/s, negatively"))
        << flown.verdict.text;
    EXPECT_NEAR(*flown.figures.ended_before_apogee_s, 0.0, 0.5) << "control went on against the spin";
  }
}

// 369 m and 8.0 s are those of an independent point mass that turns with gravity.
TEST(FlownVerdict, AGuideThatLeansIsSaidWithWhatAPointMassWouldDo) {
  const Judged flown = fly(launch2({"launch_guide.tilt_deg=15"}));
  EXPECT_TRUE(flown.notes("would reach 369 m and pass the plan's tilt limit of 60 deg 8.0 s after lift-off"));
  EXPECT_FALSE(fly(launch2()).notes("leans"));
}

TEST(FlownVerdict, WindAcrossTheGuideAndSpeedsNearSoundAreSaid) {
  EXPECT_TRUE(fly(launch2({"wind.speed_m_s=8"})).notes("the canards leave the linear range"));
  // A gust without any wind before it, where control begins.
  EXPECT_TRUE(
      fly(launch2({"flight.motion=six_dof", "wind.gust_m_s=30", "wind.gust_time_s=0.5", "wind.gust_duration_s=0.3"}))
          .notes("the canards leave the linear range"));
  EXPECT_FALSE(fly(launch2({"wind.speed_m_s=0.5"})).notes("leave the linear range"));
  EXPECT_TRUE(fly(launch2({"body.mass_kg=0.9", "body.drag_area_m2=0.0005"}))
                  .notes("drag, damping and torque are no longer constant"));
}

TEST(FlownVerdict, PrandtlGlauertPromisesNothingAboveMach08) {
  const auto notes = [](const char* mass_kg, const std::vector<std::string>& more, const char* words) {
    std::vector<std::string> changes{std::string{"body.mass_kg="} + mass_kg, "body.drag_area_m2=0.0005"};
    changes.insert(changes.end(), more.begin(), more.end());
    return fly(launch2(changes)).notes(words);
  };
  const std::vector<std::string> factor{"aerodynamics.compressibility=prandtl_glauert"};
  const std::vector<std::string> table{"body.drag_mach=[0, 0.8]", "body.drag_factor=[1, 1]"};
  // 1.6 kg reach Mach 0.77 and 0.9 kg Mach 1.3.
  EXPECT_TRUE(notes("1.6", {}, "drag, damping and torque are no longer constant"));
  EXPECT_TRUE(notes("1.6", table, ", damping and torque are no longer constant"));
  EXPECT_FALSE(notes("1.6", table, "drag, damping"));
  EXPECT_TRUE(notes("1.6", factor, ", drag is no longer constant"));
  EXPECT_FALSE(notes("1.6", factor, "damping"));
  EXPECT_TRUE(notes("0.9", factor, "nothing is promised of damping, torque and normal force"));
  EXPECT_TRUE(notes("0.9", factor, "nor of the drag"));
}

// Half of the torque is left: it settles at 2 / (0.5 0.5) from its command, and not at 4.
TEST(FlownVerdict, OneCanardThatWorksAgainstTheOthersIsSaidAndCounted) {
  const Judged one = fly(launch2({"excitation.form=none", "disturbance.angles_deg=[2]",
                                  "canards.direction=[\"reversed\",\"normal\",\"normal\",\"normal\"]"}));
  EXPECT_LT(text::degrees(*one.figures.largest_hold_error_rad), 2.0) << one.verdict.text;
  EXPECT_TRUE(one.notes("Canard 1 turns the rocket against the roll command"));
}

// Without any offset the canards turn the rocket faster and faster; with two of four they cancel.
TEST(FlownVerdict, CanardsThatAPlanTurnsTheWrongWayAreTheCauseAndNotTheFinOffset) {
  sim::Scenario scenario = launch2({"excitation.form=none", "disturbance.angles_deg=[0]"});
  scenario.plan.canards.each[0].direction = core::Direction::reversed;
  scenario.plan.canards.each[1].direction = core::Direction::reversed;
  const Judged cancelled = fly(scenario);
  EXPECT_NE(cancelled.verdict.outcome, Outcome::held) << cancelled.verdict.text;
  EXPECT_TRUE(cancelled.says("canards 1 and 2 turn the rocket against the roll command")) << cancelled.verdict.text;
  scenario.plan.canards.each[2].direction = scenario.plan.canards.each[3].direction = core::Direction::reversed;
  const Judged flown = fly(scenario);
  EXPECT_EQ(flown.verdict.outcome, Outcome::not_held);
  EXPECT_TRUE(flown.verdict.text.starts_with(
      "Roll not held: all canards turn the rocket against the roll command (direction differs between plan and "
      "vehicle). "))
      << flown.verdict.text;
  EXPECT_TRUE(flown.says(" from the command in the mean; canards at their limit")) << flown.verdict.text;
  EXPECT_FALSE(cancelled.says("fin offset") || flown.says("fin offset"));
}

TEST(FlownVerdict, FinsThatReverseTheRollAreSaidAndNothingIsHeld) {
  const Judged flown = fly(launch2({"aerodynamics.canard_wash=1.3", "aerodynamics.canard_wash_distance_m=0.9"}));
  EXPECT_TRUE(flown.notes("canards that turn one way roll the rocket the other way"));
  EXPECT_EQ(flown.verdict.outcome, Outcome::not_held);
  EXPECT_LT(*flown.figures.authority_margin_rad, 0.0);
  EXPECT_TRUE(flown.flight.loop_margins.empty());
  EXPECT_FALSE(fly(launch2({"aerodynamics.canard_wash=0.2"})).notes("take back"));
}

// 4.9 degrees of offset against 9 of the canards, of which the fins leave 7.2: it settles at 4.9 / (0.5 0.8).
TEST(FlownVerdict, ARollThatTheFinsMakeSettleElsewhereIsHeldThere) {
  const Judged flown = fly(launch2({"aerodynamics.canard_wash=0.2", "aerodynamics.canard_wash_distance_m=0.9"}));
  EXPECT_EQ(flown.verdict.outcome, Outcome::held) << flown.verdict.text;
  EXPECT_NEAR(text::degrees(*flown.figures.authority_margin_rad), 0.8 * 9.0 - 4.9, 1e-5);
}

// 0.1 N m against 0.5 1.2 22^2 0.003 N m/rad are 6.6 degrees, and the plan's limit is 9.
TEST(FlownVerdict, AServoTooWeakForTheLimitIsSaid) {
  const auto flown = [](const std::vector<std::string>& changes) {
    std::vector<input::Override> overrides{input::parse_override("run.control_time_s=3")};
    for (const std::string& change : changes) {
      overrides.push_back(input::parse_override(change));
    }
    const flight::Flight flight = fly::fly_scenario(input::load_scenario("tunnel_steps", overrides));
    return std::ranges::any_of(flight.notes, [](const std::string& note) {
      return note.find("turns a canard back beyond 6.6 deg") != std::string::npos;
    });
  };
  EXPECT_TRUE(flown({"servo.torque_n_m=0.1", "aerodynamics.canard_hinge_moment_m3=0.003", "tunnel.turbulence=0"}));
  EXPECT_FALSE(flown({"servo.torque_n_m=1", "aerodynamics.canard_hinge_moment_m3=0.003", "tunnel.turbulence=0"}));
  EXPECT_FALSE(flown({"aerodynamics.canard_hinge_moment_m3=0.003", "tunnel.turbulence=0"}));
}

TEST(FlownVerdict, WhyTheRocketWasNotArmedIsPartOfTheVerdict) {
  EXPECT_EQ(fly(launch2({"timing.pad_time_s=5"})).verdict.text,
            "No control: the rocket was never armed, because its self-test takes about seven seconds, and 4 s after it "
            "began the motor was ignited (timing.arm_time_s, timing.pad_time_s).");
  sim::Scenario biased = launch2();
  biased.vehicle.imu.specific_force_bias_m_s2 = 2.0;
  EXPECT_TRUE(fly(biased).says("the rocket was never armed, because the avionics refused to be armed: the "))
      << fly(biased).verdict.text;
}

}  // namespace
}  // namespace fantail::sil
