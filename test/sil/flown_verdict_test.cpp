// SPDX-License-Identifier: MIT
// Verdicts on flights that once misled: what the report says of a simulated flight, against the truth of the world.

#include "figures.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "report/verdict.hpp"
#include "test.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::sil {
namespace {

using report::Outcome;

struct Judged {
  flight::Flight flight;
  report::Figures figures;
  report::Verdict verdict;
  [[nodiscard]] bool says(const std::string& word) const { return fantail::says(verdict.text, word); }
  [[nodiscard]] bool tells(const Numbers& numbers) const { return fantail::tells(verdict.text, numbers); }
  /// The first note with this word; empty: none.
  [[nodiscard]] std::string note(const std::string& word) const {
    const auto found = std::ranges::find_if(flight.notes, [&](const auto& note) { return fantail::says(note, word); });
    return found == flight.notes.end() ? std::string{} : *found;
  }
  [[nodiscard]] Numbers note_figures(const std::string& word) const { return fantail::figures(note(word)); }
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
  EXPECT_TRUE(flown.tells({"1", "2", "-2.0"})) << flown.verdict.text;
}

TEST(FlownVerdict, WhereACanardStandsAtItsStopTheFinOffsetIsNotBlamedAlone) {
  sim::Scenario scenario = launch2();
  scenario.faults.push_back(
      {.device = sim::Device::servo, .how = sim::GearFault{sim::ServoFault::stuck, -scenario.vehicle.servo.stop_rad}});
  const Judged flown = fly(scenario);
  EXPECT_EQ(flown.verdict.outcome, Outcome::not_held);
  EXPECT_TRUE(flown.says("canard 1") && flown.tells({"1", "-4.9"})) << flown.verdict.text;
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
  EXPECT_FALSE(flown.flight.unmeasured.speed_bound_from_s || flown.says("accelerometer"));
  EXPECT_EQ(flown.note_figures("accelerometer"), (Numbers{"21.9", "16", "32"}));
}

TEST(FlownVerdict, AMotorBeyondTheRangeOfBothIsNotFlownToAnImaginedApogee) {
  const Judged flown = fly(strong_motor(16.0));
  EXPECT_LT(*flown.figures.ended_before_apogee_s, 0.5) << flown.verdict.text;
  EXPECT_TRUE(flown.says("accelerometer") && flown.tells({"0.10"})) << flown.verdict.text;
  EXPECT_NEAR(*flown.flight.unmeasured.speed_bound_from_s, 0.10, 0.005);
}

TEST(FlownVerdict, AnOutageOfSevenMillisecondsNeitherEndsControlNorGoesUnsaid) {
  sim::Scenario scenario = launch2();
  scenario.faults = {{.device = sim::Device::imu, .how = sim::Behaviour::hangs, .from_s = 3.0, .until_s = 3.007}};
  const Judged flown = fly(scenario);
  EXPECT_EQ(flown.verdict.outcome, Outcome::held);
  EXPECT_TRUE(flown.says("gyro") && flown.tells({"0.006", "2.99"})) << flown.verdict.text;
}

TEST(FlownVerdict, ControlThatADeadGyroEndedIsJudgedUpToApogee) {
  sim::Scenario scenario = launch2();
  scenario.faults = {{.device = sim::Device::imu, .how = sim::Behaviour::hangs, .from_s = 3.0, .until_s = 20.0}};
  const Judged flown = fly(scenario);
  EXPECT_EQ(flown.verdict.outcome, Outcome::not_held);
  const double turned_deg = text::degrees(*flown.figures.roll_after_end_rad);
  EXPECT_EQ(flown.flight.phase_changes.back().reason, core::PhaseReason::gyro_failed);
  EXPECT_TRUE(flown.says("gyro") && flown.tells({"3.24", "7.12", text::fixed(turned_deg, 1)})) << flown.verdict.text;
  EXPECT_GT(turned_deg, 360.0);
}

TEST(FlownVerdict, ALimitCycleIsNotCalledHeld) {
  const std::vector<std::string> gains{"controller.proportional_gain=10", "controller.derivative_gain_s=2"};
  const Judged excited = fly(launch2(gains));
  EXPECT_EQ(excited.verdict.outcome, Outcome::oscillates) << excited.verdict.text;
  EXPECT_FALSE(excited.figures.oscillation);
  EXPECT_TRUE(excited.tells({"82", "-46.0"})) << "speed and phase margin; " << excited.verdict.text;
  std::vector<std::string> quiet = gains;
  quiet.emplace_back("excitation.form=none");
  const Judged unexcited = fly(launch2(quiet));
  EXPECT_EQ(unexcited.verdict.outcome, Outcome::oscillates);
  ASSERT_TRUE(unexcited.figures.oscillation);
  EXPECT_TRUE(unexcited.tells({text::brief(unexcited.figures.oscillation->frequency_hz, 2)})) << unexcited.verdict.text;
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
    EXPECT_NEAR(text::degrees(flown.flight.unmeasured.spin_rad_s), std::copysign(500.0, offset_deg), 0.02);
    EXPECT_EQ(fantail::figures(flown.verdict.text).at(0), "500") << flown.verdict.text;
    EXPECT_TRUE(flown.says(offset_deg > 0.0 ? "positively" : "negatively")) << flown.verdict.text;
    EXPECT_NEAR(*flown.figures.ended_before_apogee_s, 0.0, 0.5) << "control went on against the spin";
  }
}

// 369 m and 8.0 s are those of an independent point mass that turns with gravity.
TEST(FlownVerdict, AGuideThatLeansIsSaidWithWhatAPointMassWouldDo) {
  const Judged flown = fly(launch2({"launch_guide.tilt_deg=15"}));
  EXPECT_EQ(flown.note_figures("guide"), (Numbers{"15", "369", "60", "8.0"}));
  EXPECT_EQ(fly(launch2()).note("guide"), "");
}

TEST(FlownVerdict, WindAcrossTheGuideAndSpeedsNearSoundAreSaid) {
  // At the angle of the air, with the 9 degrees of the canards, the linear range of 15 degrees is left.
  EXPECT_EQ(fly(launch2({"wind.speed_m_s=8"})).note_figures("guide"), (Numbers{"8", "16", "27", "9", "15"}));
  // A gust without any wind before it, where control begins.
  const Judged gust =
      fly(launch2({"flight.motion=six_dof", "wind.gust_m_s=30", "wind.gust_time_s=0.5", "wind.gust_duration_s=0.3"}));
  EXPECT_EQ(gust.note_figures("guide"), (Numbers{"10", "56", "0.63", "9", "15"}));
  EXPECT_EQ(fly(launch2({"wind.speed_m_s=0.5"})).note_figures("guide"), (Numbers{"0.5", "16", "2"}));
}

TEST(FlownVerdict, PrandtlGlauertPromisesNothingAboveMach08) {
  // The figures of the note, and of which quantities nothing is promised.
  const auto doubted = [](const char* mass_kg, const std::vector<std::string>& more) {
    std::vector<std::string> changes{std::string{"body.mass_kg="} + mass_kg, "body.drag_area_m2=0.0005"};
    changes.insert(changes.end(), more.begin(), more.end());
    const std::string note = fly(launch2(changes)).note("Mach");
    Numbers all = fantail::figures(note);
    std::ranges::copy_if(Numbers{"drag", "damping", "torque", "normal force"}, std::back_inserter(all),
                         [&](const std::string& quantity) { return fantail::says(note, quantity); });
    return all;
  };
  const std::vector<std::string> factor{"aerodynamics.compressibility=prandtl_glauert"};
  const std::vector<std::string> table{"body.drag_mach=[0, 0.8]", "body.drag_factor=[1, 1]"};
  // 1.6 kg reach Mach 0.77 and 0.9 kg Mach 1.3.
  EXPECT_EQ(doubted("1.6", {}), (Numbers{"264", "0.78", "drag", "damping", "torque"}));
  EXPECT_EQ(doubted("0.9", {}), (Numbers{"455", "1.35", "drag", "damping", "torque"}));
  EXPECT_EQ(doubted("1.6", table), (Numbers{"264", "0.78", "damping", "torque"}));
  EXPECT_EQ(doubted("1.6", factor), (Numbers{"264", "0.78", "drag"}));
  EXPECT_EQ(doubted("0.9", factor), (Numbers{"455", "1.35", "0.8", "drag", "damping", "torque", "normal force"}));
}

// Half of the torque is left: it settles at 2 / (0.5 0.5) from its command, and not at 4.
TEST(FlownVerdict, OneCanardThatWorksAgainstTheOthersIsSaidAndCounted) {
  const Judged one = fly(launch2({"excitation.form=none", "disturbance.angles_deg=[2]",
                                  "canards.direction=[\"reversed\",\"normal\",\"normal\",\"normal\"]"}));
  EXPECT_LT(text::degrees(*one.figures.largest_hold_error_rad), 2.0) << one.verdict.text;
  EXPECT_EQ(one.note_figures("direction"), Numbers{"1"});
}

// Without any offset the canards turn the rocket faster and faster; with two of four they cancel.
TEST(FlownVerdict, CanardsThatAPlanTurnsTheWrongWayAreTheCauseAndNotTheFinOffset) {
  sim::Scenario scenario = launch2({"excitation.form=none", "disturbance.angles_deg=[0]"});
  scenario.plan.canards.each[0].direction = core::Direction::reversed;
  scenario.plan.canards.each[1].direction = core::Direction::reversed;
  const Judged cancelled = fly(scenario);
  EXPECT_NE(cancelled.verdict.outcome, Outcome::held) << cancelled.verdict.text;
  EXPECT_EQ(fantail::figures(cancelled.flight.why_uncontrollable), (Numbers{"1", "2"}));
  EXPECT_TRUE(cancelled.says(cancelled.flight.why_uncontrollable)) << cancelled.verdict.text;
  scenario.plan.canards.each[2].direction = scenario.plan.canards.each[3].direction = core::Direction::reversed;
  const Judged flown = fly(scenario);
  EXPECT_EQ(flown.verdict.outcome, Outcome::not_held);
  EXPECT_EQ(fantail::figures(flown.flight.why_uncontrollable), Numbers{}) << "it is all of them";
  EXPECT_TRUE(flown.says("direction") && flown.says(flown.flight.why_uncontrollable)) << flown.verdict.text;
  EXPECT_TRUE(flown.tells({text::fixed(text::degrees(*flown.figures.mean_reference_error_rad), 1),
                           text::fixed(100.0 * *flown.figures.saturated_fraction, 1)}))
      << flown.verdict.text;
  EXPECT_FALSE(cancelled.says("offset") || flown.says("offset"));
}

TEST(FlownVerdict, FinsThatReverseTheRollAreSaidAndNothingIsHeld) {
  const Judged flown = fly(launch2({"aerodynamics.canard_wash=1.3", "aerodynamics.canard_wash_distance_m=0.9"}));
  EXPECT_EQ(flown.note_figures("aerodynamics.canard_wash"), Numbers{"1.3"});
  EXPECT_EQ(flown.verdict.outcome, Outcome::not_held);
  EXPECT_LT(*flown.figures.authority_margin_rad, 0.0);
  EXPECT_TRUE(flown.flight.loop_margins.empty());
  EXPECT_FALSE(fly(launch2({"aerodynamics.canard_wash=0.2"})).note("canard_wash") != "");
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
      return fantail::says(note, "servo") && fantail::tells(note, {"6.6"});
    });
  };
  EXPECT_TRUE(flown({"servo.torque_n_m=0.1", "aerodynamics.canard_hinge_moment_m3=0.003", "tunnel.turbulence=0"}));
  EXPECT_FALSE(flown({"servo.torque_n_m=1", "aerodynamics.canard_hinge_moment_m3=0.003", "tunnel.turbulence=0"}));
  EXPECT_FALSE(flown({"aerodynamics.canard_hinge_moment_m3=0.003", "tunnel.turbulence=0"}));
}

TEST(FlownVerdict, WhyTheRocketWasNotArmedIsPartOfTheVerdict) {
  const Judged too_soon = fly(launch2({"timing.pad_time_s=5"}));
  EXPECT_EQ(too_soon.verdict.outcome, Outcome::no_control);
  EXPECT_EQ(fantail::figures(too_soon.verdict.text), Numbers{"4"});
  EXPECT_TRUE(too_soon.says("timing.arm_time_s") && too_soon.says("timing.pad_time_s")) << too_soon.verdict.text;
  sim::Scenario biased = launch2();
  biased.vehicle.imu.specific_force_bias_m_s2 = 2.0;
  const Judged refused = fly(biased);
  EXPECT_EQ(refused.verdict.outcome, Outcome::no_control);
  EXPECT_TRUE(fantail::says(refused.flight.why_not_armed, "avionics") && refused.says(refused.flight.why_not_armed))
      << refused.verdict.text;
}

}  // namespace
}  // namespace fantail::sil
