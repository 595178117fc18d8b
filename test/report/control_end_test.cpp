// SPDX-License-Identifier: MIT
// How control ended, or why it never began, as the verdict says it.

#include "report/verdict.hpp"
#include "synthetic_flight.hpp"
#include "test.hpp"

namespace fantail::report {
namespace {

TEST(ControlEnd, WithoutALaunchThereIsNoControl) {
  SyntheticFlight synthetic;
  synthetic.never_controlled(-0.5, core::Phase::armed, core::PhaseReason::armed_by_switch_and_command);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::no_control);
  EXPECT_EQ(v.text, "No control: no launch was detected.");
}

TEST(ControlEnd, EveryOtherWayToNoControlIsNamed) {
  flight::Flight never_armed = SyntheticFlight{}.flight;
  never_armed.rows.clear();
  never_armed.events = {};
  never_armed.phase_changes.clear();
  EXPECT_EQ(verdict_of(never_armed).text, "No control: the rocket was never armed.");

  SyntheticFlight knock;
  knock.flight.plan.guide.clearance_time = core::from_seconds(1.5F);
  knock.never_controlled(1.7, core::Phase::armed, core::PhaseReason::guide_not_cleared_in_time);
  EXPECT_EQ(verdict_of(knock.flight).text,
            "No control: what looked like a launch did not clear the guide within 1.5 s (at 1.70 s).");

  SyntheticFlight deaf;
  deaf.never_controlled(0.3, core::Phase::armed, core::PhaseReason::gyro_failed_before_control);
  EXPECT_EQ(verdict_of(deaf.flight).text, "No control: the gyro failed before control (at 0.30 s).");
}

// A first, weak push uses up the detection; until the rocket has rested the real one is not looked for.
TEST(ControlEnd, OfALaunchThatWasNotDetectedTheFirstCauseIsNamed) {
  using core::Phase;
  using core::PhaseReason;
  SyntheticFlight synthetic;
  synthetic.flight.plan.guide.clearance_time = core::from_seconds(1.5F);
  synthetic.never_controlled(4.73, Phase::finished, PhaseReason::flew_without_launch);
  const auto after = [&synthetic](std::vector<flight::PhaseChange> changes) {
    changes.push_back({4.73, Phase::finished, PhaseReason::flew_without_launch});
    synthetic.flight.phase_changes = std::move(changes);
    return verdict_of(synthetic.flight).text;
  };
  const flight::PhaseChange armed{-9.0, Phase::armed, PhaseReason::armed_by_switch_and_command};
  const flight::PhaseChange launched{0.13, Phase::launched, PhaseReason::launch_detected};
  const flight::PhaseChange back{1.62, Phase::armed, PhaseReason::guide_not_cleared_in_time};
  const std::string flew = "; at 4.73 s the rocket reported that it had flown.";
  const std::string chuff =
      "No control: what looked like a launch did not clear the guide within 1.5 s (at 1.62 s)" + flew;
  EXPECT_EQ(after({armed, launched, back}), chuff);
  EXPECT_EQ(after({launched, back}), chuff) << "as a log has it that begins with the push";
  EXPECT_EQ(after({armed}), "No control: no launch was detected" + flew);
  EXPECT_EQ(after({}), "No control: no launch was detected" + flew);
  EXPECT_EQ(after({armed, {-2.0, Phase::armed, PhaseReason::moved_without_launch}}),
            "No control: no launch was detected: the rocket had moved and had to rest first, from -2.00 s on" + flew);
  EXPECT_EQ(after({armed, {2.5, Phase::armed, PhaseReason::moved_without_launch}}),
            "No control: no launch was detected in the first 2.50 s of the flight" + flew);
  EXPECT_EQ(after({armed, launched, back, {3.0, Phase::armed, PhaseReason::rested}}),
            "No control: no launch was detected after the rocket had rested at 3.00 s" + flew);
}

TEST(ControlEnd, OfATableThatHasNoControlOnlyItsRowsAreTold) {
  SyntheticFlight table;
  table.flight.seed.reset();
  const auto text_of_rows = [&table](std::size_t begin, std::size_t end, std::optional<core::Phase> all) {
    flight::Flight part = table.flight;
    part.rows.assign(table.flight.rows.begin() + static_cast<std::ptrdiff_t>(begin),
                     table.flight.rows.begin() + static_cast<std::ptrdiff_t>(end));
    part.phase_changes.clear();
    part.events = {};
    for (flight::Row& row : part.rows) {
      row.phase = all.value_or(row.phase);
    }
    if (part.rows.back().phase != core::Phase::safe) {
      part.phase_changes = {{part.rows.back().time_s, part.rows.back().phase, std::nullopt}};
    }
    return verdict_of(part).text;
  };
  EXPECT_EQ(text_of_rows(0, 600, core::Phase::safe), "No control in the log: in every row the phase is Safe.");
  EXPECT_EQ(text_of_rows(0, 600, {}), "No control in the log: in every row the phase is Armed.");
  EXPECT_EQ(text_of_rows(0, 1000, {}), "No control in the log: in its last row the phase is Launched.");
  EXPECT_EQ(text_of_rows(4000, 5000, core::Phase::finished),
            "No control in the log: in every row the phase is Finished.");
}

TEST(ControlEnd, ControlThatAFaultEndedBeforeApogeeIsCutShort) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 4.4;
  synthetic.end_control(3.0, core::PhaseReason::gyro_failed);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_EQ(v.text,
            "Control ended at 3.00 s, 1.40 s before apogee: the gyro failed. After that the rocket turned by up to 0.0 "
            "deg until apogee. Until then: steady, 10.0 deg from the command: roll stayed within 0.0 deg of where this "
            "law settles; "
            "canards at their "
            "limit 0.0 % of control time, 4.0 deg to spare against the fin offset.");
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
  EXPECT_TRUE(v.text.find("turned by up to 140.0 deg until apogee") != std::string::npos) << v.text;
}

TEST(ControlEnd, AnApogeeThatTheAvionicsImaginedIsAnEarlyEndToo) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 4.4;
  synthetic.end_control(3.0, core::PhaseReason::apogee);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_TRUE(
      v.text.starts_with("Control ended at 3.00 s, 1.40 s before apogee: the avionics took it for apogee. After"))
      << v.text;

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
  EXPECT_TRUE(
      v.text.starts_with("Control ended at 3.00 s, 1.40 s before apogee: the plan's control time of 2.4 s was "
                         "over. After that the rocket turned by up to 0.0 deg until apogee. Until then: steady"))
      << v.text;
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->roll_angle_rad += row.time_s > 3.0 ? text::radians(525.0 * (row.time_s - 3.0)) : 0.0;
  }
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::not_held);
  EXPECT_NE(verdict_of(synthetic.flight).text.find("turned by up to 735.0 deg until apogee"), std::string::npos);

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
  EXPECT_TRUE(v.text.starts_with("Control ended at 3.00 s, 1.40 s before apogee; the log does not say why. After that"))
      << v.text;
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
  EXPECT_NE(v.text.find("turned by up to 150.0 deg until the trajectory ends."), std::string::npos) << v.text;
}

TEST(ControlEnd, ControlThatGoesOnLongAfterApogeeIsSaid) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 3.0;
  synthetic.end_control(4.0, core::PhaseReason::control_time_over);
  EXPECT_TRUE(verdict_of(synthetic.flight).text.ends_with(" Control went on for 1.00 s after apogee."));
}

}  // namespace
}  // namespace fantail::report
