// SPDX-License-Identifier: MIT
#include "report/verdict.hpp"

#include "flight/phase_names.hpp"
#include "report/results.hpp"
#include "synthetic_flight.hpp"
#include "test.hpp"

namespace fantail::report {
namespace {

TEST(Verdict, AHeldFlightNamesErrorSaturationAndMargin) {
  SyntheticFlight synthetic;
  int count = 0;
  synthetic.each_controlled([&count](flight::Row& row) {
    row.saturated = count++ < 234;  // 234 of 3901: 6.0 %
    row.truth->roll_angle_rad += text::radians(2.1);
  });
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_EQ(v.text,
            "Steady, 10.0 deg from the command: after the first second of control, roll stayed within 2.1 deg of where "
            "this law settles; canards at their limit 6.0 % of control time; the canards can give 4.0 deg more than "
            "the fins need.");
}

TEST(Verdict, ALimitThatEndsControlInTheLastHalfSecondIsNamedThoughTheRollIsHeld) {
  SyntheticFlight tilted;
  tilted.end_control(4.1, core::PhaseReason::tilted_too_far);
  EXPECT_EQ(verdict_of(tilted.flight).outcome, Outcome::held);
  EXPECT_FALSE(verdict_of(tilted.flight).ended_by_tilt);
  EXPECT_FALSE(verdict_of(tilted.flight).allowed_tilt_end_s);
  EXPECT_TRUE(verdict_of(tilted.flight).text.ends_with("The tilt limit ended control 0.40 s before apogee."))
      << verdict_of(tilted.flight).text;
  SyntheticFlight usual;
  usual.end_control(4.1, core::PhaseReason::apogee);
  EXPECT_FALSE(says(verdict_of(usual.flight), "apogee")) << verdict_of(usual.flight).text;
  SyntheticFlight early;
  early.end_control(3.9, core::PhaseReason::tilted_too_far);
  EXPECT_EQ(verdict_of(early.flight).outcome, Outcome::cut_short);
  EXPECT_TRUE(verdict_of(early.flight).ended_by_tilt);
}

TEST(Verdict, NothingButTheTiltLimitMayEndControlAsEarlyAsTheScenarioAllowsIt) {
  SyntheticFlight tilted;
  tilted.flight.tilt_end_before_apogee_s = 0.7;
  tilted.end_control(3.9, core::PhaseReason::tilted_too_far);
  EXPECT_EQ(verdict_of(tilted.flight).outcome, Outcome::held);
  EXPECT_NEAR(verdict_of(tilted.flight).allowed_tilt_end_s.value(), 0.6, 1e-9);
  EXPECT_TRUE(says(verdict_of(tilted.flight),
                   "The tilt limit ended control 0.60 s before apogee. "
                   "verdict.tilt_end_before_apogee_s = 0.7 allows that. After that"))
      << verdict_of(tilted.flight).text;
  SyntheticFlight failed;
  failed.flight.tilt_end_before_apogee_s = 0.7;
  failed.end_control(3.9, core::PhaseReason::canard_fault);
  EXPECT_EQ(verdict_of(failed.flight).outcome, Outcome::cut_short);
}

TEST(Verdict, OfHeldFlightsItIsSaidHowManyRestOnTheAllowanceAndHowEarlyTheirControlEnded) {
  AllowedTiltEnds ends;
  ends.add(std::nullopt);
  EXPECT_EQ(ends.sentence(3, "run"), "");
  ends.add(2.5);
  ends.add(7.346);
  EXPECT_EQ(ends.sentence(3, "run"),
            "In 2 of 3 held runs the tilt limit ended control up to 7.35 s before apogee, which "
            "verdict.tilt_end_before_apogee_s allows");
}

TEST(Verdict, SaysWhichTimeTheHoldErrorLeavesOut) {
  SyntheticFlight stepped;
  stepped.flight.plan.reference.kind = core::ReferenceKind::steps;
  EXPECT_TRUE(says(verdict_of(stepped.flight), "after the first second of control, roll")) << "no step";
  stepped.flight.plan.reference.step_times_count = 1;
  EXPECT_TRUE(says(verdict_of(stepped.flight), "after the first second of control and of each step, roll"));
  stepped.flight.tunnel = true;
  stepped.each_controlled([](flight::Row& row) { row.truth->speed_m_s = 20.0; });
  EXPECT_TRUE(says(verdict_of(stepped.flight), "after the first two seconds of control and of each step, roll"));
}

TEST(Verdict, InATunnelTheSwirlCountsWithTheFins) {
  SyntheticFlight synthetic;
  synthetic.flight.tunnel = true;
  synthetic.each_controlled([](flight::Row& row) { row.truth->speed_m_s = 20.0; });
  EXPECT_TRUE(says(verdict_of(synthetic.flight), "4.0 deg more than the fins and the swirl need"))
      << verdict_of(synthetic.flight).text;
}

TEST(Verdict, ATrajectoryThatEndsInTheClimbIsNoWholeFlight) {
  SyntheticFlight held;
  held.flight.trajectory_end_s = 4.5;
  held.flight.events.apogee_s.reset();
  const Verdict v = verdict_of(held.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_FALSE(v.ended_early);  // it was not control that ended
  EXPECT_EQ(numbers(v), (Numbers{"4.50", "10.0", "0.0", "0.0", "4.0"}));
  EXPECT_TRUE(says(v, "trajectory")) << v.text;
  SyntheticFlight lost = held;
  lost.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad += text::radians(-24.0); });
  EXPECT_EQ(verdict_of(lost.flight).outcome, Outcome::not_held);
  EXPECT_EQ(numbers(verdict_of(lost.flight)), (Numbers{"4.50", "24.0", "34.0", "0.0", "4.0"}));
  SyntheticFlight ended = held;
  ended.end_control(3.0, core::PhaseReason::tilted_too_far);
  EXPECT_EQ(verdict_of(ended.flight).outcome, Outcome::cut_short);
  EXPECT_TRUE(verdict_of(ended.flight).ended_early);
  EXPECT_EQ(numbers(verdict_of(ended.flight)), (Numbers{"4.50", "3.00", "0.0", "10.0", "0.0", "0.0", "4.0"}));
  EXPECT_TRUE(says(verdict_of(ended.flight), flight::display_name(core::PhaseReason::tilted_too_far)));
}

// It stays within ten degrees of anything, as a rocket does that nothing turns.
TEST(Verdict, ARocketThatItsCanardsDoNotTurnIsNotCalledHeld) {
  SyntheticFlight synthetic;
  synthetic.flight.airframe = flight::FlownAirframe{};
  Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_EQ(numbers(v), Numbers{});
  EXPECT_TRUE(says(v, "canards")) << v.text;
  synthetic.flight.loop_margins = {{20.0, 1.5, {}, 0.002}, {80.0, 1.5, {}, 0.01}};
  v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_EQ(numbers(v), (Numbers{"100", "3.9"})) << "to settle, and under control: " << v.text;
  synthetic.flight.loop_margins[1].crossover_rad_s = 10.0;
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::held);
  // What was not held stays so.
  synthetic.flight.loop_margins.clear();
  synthetic.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad += text::radians(-24.0); });
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::not_held);
}

// A guide that is longer than the plan's: the canards moved while it still held the rocket.
TEST(Verdict, ControlThatBeginsOnTheGuideIsNamedAndTakesTheGreen) {
  SyntheticFlight synthetic;
  const double start_s = synthetic.flight.events.control_start_s.value();
  const auto page_of = [&] { return results(synthetic.flight, {}).document; };
  synthetic.flight.events.guide_clear_s = start_s - 0.2;
  EXPECT_FALSE(says(verdict_of(synthetic.flight), "guide"));
  EXPECT_EQ(tone(page_of().verdict), page::Tone::good);
  synthetic.flight.events.guide_clear_s = start_s + 0.25;
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_TRUE(says(v, " Control began 0.250 s before the rocket left the launch guide")) << v.text;
  EXPECT_EQ(tone(page_of().verdict), page::Tone::unsure);
  synthetic.flight.events.guide_clear_s.reset();  // of a log nobody knows
  EXPECT_FALSE(says(verdict_of(synthetic.flight), "guide"));
}

TEST(Verdict, ALargeErrorIsNotCalledHeld) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad += text::radians(-24.0); });
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_held);
  EXPECT_EQ(v.text,
            "Roll not held: after the first second of control, up to 24.0 deg from where this law settles; in the mean "
            "34.0 deg from the command; canards at their limit 0.0 % of control time; the canards can give 4.0 deg "
            "more than the fins need.");
}

TEST(Verdict, AnOffsetBeyondTheCanardsIsSaidPlainly) {
  SyntheticFlight synthetic;
  synthetic.flight.plan.controller.canard_limit = core::Angle::from_degrees(6.0F);
  synthetic.each_controlled([](flight::Row& row) {
    row.truth->disturbance_rad = text::radians(row.time_s < 1.6 ? -5.0 : -7.3);
    row.command_rad = text::radians(6.0);
    row.saturated = row.time_s >= 1.6795;
  });
  synthetic.end_control(4.4, core::PhaseReason::apogee);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_held);  // saturated 1.68 .. 4.399 s: 2720 of 3800 ticks
  EXPECT_EQ(numbers(v), (Numbers{"6", "1.68", "-7.3", "71.6", "1.3"}));
  EXPECT_TRUE(says(v, "+6 deg") && says(v, "offset of -7.3 deg")) << v.text;
}

TEST(Verdict, CanardsAtTheirLimitForAnotherReasonAreNotBlamedOnTheOffset) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) {
    row.saturated = row.time_s > 3.4995;
    row.command_rad = text::radians(-9.0);
  });
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_EQ(numbers(v), (Numbers{"10.0", "0.0", "25.7", "4.0", "-9", "3.50"})) << v.text;
}

TEST(Verdict, WhatHandsTurnInStillAirIsNotJudged) {
  SyntheticFlight synthetic;
  synthetic.flight.tunnel = true;
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->speed_m_s = 0.0;
    row.truth->roll_angle_rad += text::radians(20.0);
  }
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_EQ(numbers(v), Numbers{"0.0"});
  EXPECT_TRUE(says(v, "air ")) << v.text;
  EXPECT_FALSE(v.roll_is_judged);
  const Figures f = figures(synthetic.flight);
  EXPECT_FALSE(f.largest_hold_error_rad || f.mean_hold_error_rad || f.authority_margin_rad);
}

TEST(Verdict, ASpinBeyondTheGyrosRangeIsNoMissingSensor) {
  SyntheticFlight synthetic;
  synthetic.flight.unmeasured = {.spin_from_s = 0.8, .spin_for_s = 0.4, .spin_rad_s = text::radians(-2000.0)};
  synthetic.end_control(1.2, core::PhaseReason::gyro_failed);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_held);
  EXPECT_EQ(numbers(v), (Numbers{"1.20", "3.30", "0.0", "2000", "0.40", "0.80", "0.60", "0.0"})) << v.text;
  EXPECT_TRUE(says(v, "gyro's range") && says(v, "negative")) << v.text;
}

TEST(Verdict, WhatWasBridgedOrIsALowerBoundIsSaid) {
  SyntheticFlight synthetic;
  synthetic.flight.unmeasured = {.silent_from_s = 2.0, .silent_for_s = 0.012, .speed_bound_from_s = 0.3};
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_EQ(numbers(v), (Numbers{"10.0", "0.0", "0.0", "4.0", "0.012", "2.00", "0.30"})) << v.text;
  EXPECT_TRUE(says(v, "gyro") && says(v, "accelerometer")) << v.text;
}

TEST(Verdict, CanardsThatKeepSwingingAreNotCalledHeld) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) {
    row.truth->canard_rad = text::radians(3.5 + 4.8 * std::sin(2.0 * std::numbers::pi * 13.0 * row.time_s));
  });
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::oscillates);
  EXPECT_EQ(numbers(v), (Numbers{"13", "-1.3", "8.3", "1.60", "10.0", "0.0", "0.0", "4.0"})) << v.text;
}

TEST(Verdict, ALoopThatIsUnstableAtASpeedThatWasFlownIsNotCalledHeld) {
  SyntheticFlight synthetic;
  synthetic.flight.loop_margins = {{20.0, text::radians(55.0), 12.0}, {47.0, text::radians(-10.0), 0.7}};
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::oscillates);
  EXPECT_EQ(numbers(v), (Numbers{"47", "-10.0", "10.0", "0.0", "0.0", "4.0"})) << v.text;
}

TEST(Verdict, ControlThatNeverSettledIsNotJudged) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 1.1;
  synthetic.end_control(1.1, core::PhaseReason::control_time_over);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_EQ(numbers(v), (Numbers{"0.50", "0.0"})) << v.text;

  SyntheticFlight restless;
  restless.each_controlled(
      [](flight::Row& row) { row.reference_rad = static_cast<int>(row.time_s * 2.0) % 2 == 0 ? 0.1 : -0.1; });
  EXPECT_EQ(verdict_of(restless.flight).outcome, Outcome::not_judged);
  EXPECT_EQ(numbers(verdict_of(restless.flight)), Numbers{"0.0"});
  EXPECT_TRUE(says(verdict_of(restless.flight), "reference"));
}

TEST(Verdict, WithoutTruthTheSettlePointIsUnknown) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) { row.truth.reset(); });
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_EQ(numbers(v), Numbers{"0.0"});
  EXPECT_TRUE(says(v, "fin offset")) << v.text;
}

TEST(Verdict, WithoutProportionalGainTheOffsetIsNotCalledUnknown) {
  SyntheticFlight synthetic;
  synthetic.flight.plan.controller.proportional_gain = 0.0F;
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_TRUE(says(v, "proportional gain") && !says(v, "offset")) << v.text;
}

TEST(Verdict, AFaultyCanardIsNamedOnceWithItsNumberAndWhatBecameOfIt) {
  SyntheticFlight synthetic;
  synthetic.flight.canard_verdict_changes = {{3.1, 1, core::CanardVerdict::stalled},
                                             {3.3, 1, core::CanardVerdict::healthy},
                                             {3.4, 1, core::CanardVerdict::slipping}};
  const auto expect = [&synthetic](const Numbers& of_canard, bool slipping, bool healthy) {
    const Verdict v = verdict_of(synthetic.flight);
    Numbers all{"10.0", "0.0", "0.0", "4.0"};
    all.insert(all.end(), of_canard.begin(), of_canard.end());
    EXPECT_EQ(numbers(v), all) << v.text;
    EXPECT_TRUE(says(v, "Canard 2 stalled") && says(v, "slipping") == slipping) << v.text;
    EXPECT_EQ(says(v, "healthy"), healthy) << v.text;
  };
  expect({"2", "3.10"}, true, true);
  synthetic.flight.canard_verdict_changes.push_back({10.4, 1, core::CanardVerdict::healthy});
  expect({"2", "3.10", "10.40"}, true, true);
  synthetic.flight.canard_verdict_changes.pop_back();
  synthetic.flight.canard_verdict_changes.pop_back();
  expect({"2", "3.10", "3.30"}, false, true);
  synthetic.flight.canard_verdict_changes.pop_back();
  expect({"2", "3.10"}, false, false);
}

}  // namespace
}  // namespace fantail::report
