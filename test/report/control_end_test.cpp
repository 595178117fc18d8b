// SPDX-License-Identifier: MIT
// How control ended, as the verdict says it.
#include "flight/phase_names.hpp"
#include "report/verdict.hpp"
#include "synthetic_flight.hpp"
#include "test.hpp"

namespace fantail::report {
namespace {

TEST(ControlEnd, ControlThatAFaultEndedBeforeApogeeIsCutShort) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 4.4;
  synthetic.end_control(3.0, core::PhaseReason::gyro_failed);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_TRUE(v.ended_early);
  EXPECT_EQ(numbers(v), (Numbers{"3.00", "1.40", "0.0", "10.0", "0.0", "0.0", "4.0"})) << v.text;
  EXPECT_TRUE(says(v, flight::display_name(core::PhaseReason::gyro_failed))) << v.text;
}

TEST(ControlEnd, WhatTheRocketTurnsAfterAnEarlyEndOfControlCounts) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 4.4;
  synthetic.end_control(3.0, core::PhaseReason::gyro_failed);
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->roll_angle_rad += row.time_s > 3.0 ? text::radians(100.0 * (row.time_s - 3.0)) : 0.0;
  }
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_held);
  EXPECT_EQ(numbers(v), (Numbers{"3.00", "1.40", "140.0", "10.0", "0.0", "0.0", "4.0"})) << v.text;
}

TEST(ControlEnd, AnApogeeThatTheAvionicsImaginedIsAnEarlyEndToo) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 4.4;
  synthetic.end_control(3.0, core::PhaseReason::apogee);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_EQ(numbers(v), (Numbers{"3.00", "1.40", "0.0", "10.0", "0.0", "0.0", "4.0"})) << v.text;
  EXPECT_TRUE(says(v, "avionics")) << v.text;

  SyntheticFlight in_time;
  in_time.flight.events.apogee_s = 4.4;
  in_time.end_control(4.35, core::PhaseReason::apogee);
  EXPECT_EQ(verdict_of(in_time.flight).outcome, Outcome::held);
}

TEST(ControlEnd, AnEndByThePlansOwnTimeIsJudgedAsAnyOther) {
  SyntheticFlight synthetic;
  synthetic.flight.plan.run.control_time = core::from_seconds(2.4F);
  synthetic.flight.events.apogee_s = 4.4;
  synthetic.end_control(3.0, core::PhaseReason::control_time_over);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_EQ(numbers(v), (Numbers{"3.00", "1.40", "2.4", "0.0", "10.0", "0.0", "0.0", "4.0"})) << v.text;
  EXPECT_TRUE(says(v, "plan")) << v.text;
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->roll_angle_rad += row.time_s > 3.0 ? text::radians(525.0 * (row.time_s - 3.0)) : 0.0;
  }
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::not_held);
  EXPECT_EQ(numbers(verdict_of(synthetic.flight)).at(3), "735.0");

  SyntheticFlight to_the_top;
  to_the_top.flight.events.apogee_s = 4.4;
  to_the_top.end_control(4.0, core::PhaseReason::control_time_over);
  EXPECT_EQ(verdict_of(to_the_top.flight).outcome, Outcome::held);
}

TEST(ControlEnd, InTheTunnelThePlansOwnTimeIsTheEndOfTheRun) {
  SyntheticFlight synthetic;
  synthetic.flight.tunnel = true;
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->speed_m_s = 22.0;
  }
  synthetic.flight.events.apogee_s.reset();
  synthetic.end_control(4.4, core::PhaseReason::control_time_over);
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::held) << verdict_of(synthetic.flight).text;
}

TEST(ControlEnd, AnEndForAReasonThatATableDoesNotSayIsOneToo) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 4.4;
  synthetic.end_control(3.0, core::PhaseReason::gyro_failed);
  synthetic.flight.phase_changes.back().reason.reset();
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_EQ(numbers(v), (Numbers{"3.00", "1.40", "0.0", "10.0", "0.0", "0.0", "4.0"})) << v.text;
  EXPECT_TRUE(says(v, "log")) << v.text;
}

TEST(ControlEnd, OnATrajectoryThatEndsInTheClimbWhatTheRocketTurnsAfterwardsCountsToItsEnd) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s.reset();
  synthetic.flight.trajectory_end_s = 4.5;
  synthetic.end_control(3.0, core::PhaseReason::control_time_over);
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->roll_angle_rad += row.time_s > 3.0 ? text::radians(100.0 * (row.time_s - 3.0)) : 0.0;
  }
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::not_held);
  EXPECT_EQ(numbers(v), (Numbers{"4.50", "3.00", "30", "150.0", "10.0", "0.0", "0.0", "4.0"})) << v.text;
}

TEST(ControlEnd, ControlThatGoesOnLongAfterApogeeIsSaid) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 3.0;
  synthetic.end_control(4.0, core::PhaseReason::control_time_over);
  EXPECT_EQ(numbers(verdict_of(synthetic.flight)), (Numbers{"10.0", "0.0", "0.0", "4.0", "1.00"}));
}

}  // namespace
}  // namespace fantail::report
