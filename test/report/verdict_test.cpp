// SPDX-License-Identifier: MIT
#include "report/verdict.hpp"

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
            "Steady, 10.0 deg from the command: roll stayed within 2.1 deg of where this law settles; canards at their "
            "limit 6.0 % of control time, 4.0 deg to spare against the fin offset.");
}

TEST(Verdict, ATrajectoryThatEndsInTheClimbIsNoWholeFlight) {
  SyntheticFlight held;
  held.flight.trajectory_end_s = 4.5;
  held.flight.events.apogee_s.reset();
  const Verdict v = verdict_of(held.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_FALSE(v.ended_early);  // it was not control that ended
  EXPECT_EQ(v.text,
            "Until the trajectory ends at 4.50 s, before apogee: steady, 10.0 deg from the command: roll stayed within "
            "0.0 deg of where this law settles; "
            "canards at their limit 0.0 % of control time, 4.0 deg to spare against the fin offset.");
  SyntheticFlight lost = held;
  lost.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad += text::radians(-24.0); });
  EXPECT_EQ(verdict_of(lost.flight).outcome, Outcome::not_held);
  EXPECT_NE(verdict_of(lost.flight).text.find("before apogee: roll not held: up to 24.0 deg"), std::string::npos);
  SyntheticFlight ended = held;
  ended.end_control(3.0, core::PhaseReason::tilted_too_far);
  EXPECT_EQ(verdict_of(ended.flight).outcome, Outcome::cut_short);
  EXPECT_TRUE(verdict_of(ended.flight).ended_early);
  EXPECT_NE(verdict_of(ended.flight).text.find("ends at 4.50 s, before apogee: control ended at 3.00 s: "),
            std::string::npos);
}

// It stays within ten degrees of anything, as a rocket does that nothing turns.
TEST(Verdict, ARocketThatItsCanardsDoNotTurnIsNotCalledHeld) {
  SyntheticFlight synthetic;
  synthetic.flight.airframe = flight::FlownAirframe{};
  Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_EQ(v.text, "Roll not judged: the canards do not turn the rocket enough for the loop to have a gain of one.");
  synthetic.flight.loop_margins = {{20.0, 1.5, {}, 0.002}, {80.0, 1.5, {}, 0.01}};
  v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_NE(v.text.find("the loop would need 100 s or more to settle, and control lasted 3.9 s"), std::string::npos)
      << v.text;
  synthetic.flight.loop_margins[1].crossover_rad_s = 10.0;
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::held);
  // What was not held stays so.
  synthetic.flight.loop_margins.clear();
  synthetic.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad += text::radians(-24.0); });
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::not_held);
}

TEST(Verdict, ALargeErrorIsNotCalledHeld) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad += text::radians(-24.0); });
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_held);
  EXPECT_EQ(v.text,
            "Roll not held: up to 24.0 deg from where this law settles, in the mean 34.0 deg from the command; canards "
            "at their limit 0.0 % of control time, "
            "4.0 deg to spare against the fin offset.");
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
  EXPECT_EQ(v.text,
            "Canards commanded to their limit (+6 deg) from 1.68 s to the end of control: the fin offset of -7.3 deg "
            "is beyond what they can balance; roll not held. Canards at their limit 71.6 % of control time, 1.3 deg "
            "too few against the fin offset.");
}

TEST(Verdict, CanardsAtTheirLimitForAnotherReasonAreNotBlamedOnTheOffset) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) {
    row.saturated = row.time_s > 3.4995;
    row.command_rad = text::radians(-9.0);
  });
  EXPECT_EQ(verdict_of(synthetic.flight).text,
            "Steady, 10.0 deg from the command: roll stayed within 0.0 deg of where this law settles; canards at their "
            "limit 25.7 % of control time, 4.0 deg to spare against the fin offset. Canards commanded to their limit "
            "(-9 deg) from 3.50 s to the end of "
            "control.");
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
  EXPECT_EQ(v.text,
            "Roll not judged: the air stands still, so the canards cannot turn the rocket; canards at their limit 0.0 "
            "% of control time.");
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
  EXPECT_NE(
      v.text.find("the rocket turned faster than the gyro's range of 2000 deg/s, negatively, for 0.40 s in all, first "
                  "at 0.80 s. Roll not judged: control lasted only 0.60 s"),
      std::string::npos)
      << v.text;
}

TEST(Verdict, WhatWasBridgedOrIsALowerBoundIsSaid) {
  SyntheticFlight synthetic;
  synthetic.flight.unmeasured = {.silent_from_s = 2.0, .silent_for_s = 0.012, .speed_bound_from_s = 0.3};
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_TRUE(v.text.ends_with(
      " The gyro gave no usable rate for 0.012 s in all, first at 2.00 s; no roll was commanded meanwhile. From "
      "0.30 s on the avionics knew only lower bounds of height and speed, because every accelerometer was at the end "
      "of its range."))
      << v.text;
}

TEST(Verdict, CanardsThatKeepSwingingAreNotCalledHeld) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) {
    row.truth->canard_rad = text::radians(3.5 + 4.8 * std::sin(2.0 * std::numbers::pi * 13.0 * row.time_s));
  });
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::oscillates);
  EXPECT_TRUE(
      v.text.starts_with("The canards oscillate at 13 Hz between -1.3 and 8.3 deg, seen from 1.60 s on, with "
                         "nothing that excites them. Steady, 10.0 deg from the command: roll stayed within 0.0 deg"))
      << v.text;
}

TEST(Verdict, ALoopThatIsUnstableAtASpeedThatWasFlownIsNotCalledHeld) {
  SyntheticFlight synthetic;
  synthetic.flight.loop_margins = {{20.0, text::radians(55.0), 12.0}, {47.0, text::radians(-10.0), 0.7}};
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::oscillates);
  EXPECT_TRUE(v.text.starts_with("The loop is unstable: at 47 m/s its phase margin is -10.0 deg. Steady, 10.0 deg"))
      << v.text;
}

TEST(Verdict, ControlThatNeverSettledIsNotJudged) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 1.1;
  synthetic.end_control(1.1, core::PhaseReason::control_time_over);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_TRUE(v.text.starts_with("Roll not judged: control lasted only 0.50 s; canards at their limit 0.0 %"))
      << v.text;

  SyntheticFlight restless;
  restless.each_controlled(
      [](flight::Row& row) { row.reference_rad = static_cast<int>(row.time_s * 2.0) % 2 == 0 ? 0.1 : -0.1; });
  EXPECT_TRUE(verdict_of(restless.flight).text.starts_with("Roll not judged: the reference was never constant"));
}

TEST(Verdict, WithoutTruthTheSettlePointIsUnknown) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) { row.truth.reset(); });
  EXPECT_EQ(verdict_of(synthetic.flight).text,
            "Roll not judged: the fin offset, and with it where roll should settle, is unknown; canards at their limit "
            "0.0 % of control time.");
}

TEST(Verdict, WithoutProportionalGainTheOffsetIsNotCalledUnknown) {
  SyntheticFlight synthetic;
  synthetic.flight.plan.controller.proportional_gain = 0.0F;
  EXPECT_TRUE(verdict_of(synthetic.flight)
                  .text.starts_with("Roll not judged: without proportional gain nothing holds an angle; canards"));
}

TEST(Verdict, AFaultyCanardIsNamedOnceWithItsNumberAndWhatBecameOfIt) {
  SyntheticFlight synthetic;
  synthetic.flight.canard_verdict_changes = {{3.1, 1, core::CanardVerdict::stalled},
                                             {3.3, 1, core::CanardVerdict::healthy},
                                             {3.4, 1, core::CanardVerdict::slipping}};
  EXPECT_TRUE(
      verdict_of(synthetic.flight)
          .text.ends_with(
              "against the fin offset. Canard 2 stalled, slipping from 3.10 s to the end, healthy in between."));
  synthetic.flight.canard_verdict_changes.push_back({10.4, 1, core::CanardVerdict::healthy});
  EXPECT_TRUE(
      verdict_of(synthetic.flight)
          .text.ends_with(" Canard 2 stalled, slipping from 3.10 s to 10.40 s, healthy in between, then healthy."));
  synthetic.flight.canard_verdict_changes.pop_back();
  synthetic.flight.canard_verdict_changes.pop_back();
  EXPECT_TRUE(verdict_of(synthetic.flight).text.ends_with(" Canard 2 stalled from 3.10 s to 3.30 s, then healthy."));
  synthetic.flight.canard_verdict_changes.pop_back();
  EXPECT_TRUE(verdict_of(synthetic.flight).text.ends_with(" Canard 2 stalled from 3.10 s to the end."));
}

}  // namespace
}  // namespace fantail::report
