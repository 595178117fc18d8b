// SPDX-License-Identifier: MIT
// Why control never began, as the verdict says it, and where canards stood meanwhile.
#include "flight/phase_names.hpp"
#include "report/answer.hpp"
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

// It may have been launched after that.
TEST(ControlEnd, ARecordTellsOfNoLaunchAsFarAsItGoes) {
  SyntheticFlight record;
  record.never_controlled(-0.5, core::Phase::armed, core::PhaseReason::armed_by_switch_and_command);
  record.flight.seed.reset();
  EXPECT_EQ(verdict_of(record.flight).text, "No control: no launch was detected up to 4.50 s, where the record ends.");
}

TEST(ControlEnd, ControlMayHaveBegunInAHoleThatEndsTheFlight) {
  SyntheticFlight hidden;
  hidden.never_controlled(4.0, core::Phase::finished, core::PhaseReason::apogee);
  for (flight::Row& row : hidden.flight.rows) {
    row.phase = row.phase == core::Phase::finished && row.time_s < 4.0 ? core::Phase::launched : row.phase;
  }
  EXPECT_EQ(verdict_of(hidden.flight).outcome, Outcome::no_control);
  std::erase_if(hidden.flight.rows, [](const flight::Row& row) { return row.time_s > 0.5 && row.time_s < 4.0; });
  EXPECT_EQ(verdict_of(hidden.flight).outcome, Outcome::not_judged);
  EXPECT_TRUE(says(verdict_of(hidden.flight), "no tick under control is on record"));
}

// How soon before apogee the tilt limit may end control is a number of the scenario.
TEST(ControlEnd, OfALogByTheTiltLimitIsNotCalledEarly) {
  SyntheticFlight log;
  log.end_control(3.0, core::PhaseReason::tilted_too_far);
  EXPECT_EQ(verdict_of(log.flight).outcome, Outcome::cut_short) << "1.5 s before apogee, and 0.5 s are allowed";
  log.flight.seed.reset();
  log.flight.events.apogee_s.reset();
  EXPECT_FALSE(verdict_of(log.flight).ended_early);
  EXPECT_TRUE(says(verdict_of(log.flight), "The tilt limit ended control at 3.00 s."));
}

TEST(ControlEnd, EveryOtherWayToNoControlIsNamed) {
  flight::Flight never_armed = SyntheticFlight{}.flight;
  never_armed.rows.clear();
  never_armed.events = {};
  never_armed.phase_changes.clear();
  EXPECT_EQ(verdict_of(never_armed).outcome, Outcome::no_control);
  EXPECT_TRUE(says(verdict_of(never_armed), "armed"));

  SyntheticFlight knock;
  knock.flight.plan.guide.clearance_time = core::from_seconds(1.5F);
  knock.never_controlled(1.7, core::Phase::armed, core::PhaseReason::guide_not_cleared_in_time);
  EXPECT_EQ(verdict_of(knock.flight).outcome, Outcome::no_control);
  EXPECT_EQ(numbers(verdict_of(knock.flight)), (Numbers{"1.5", "1.70"}));
  EXPECT_TRUE(says(verdict_of(knock.flight), "guide"));

  SyntheticFlight deaf;
  deaf.never_controlled(0.3, core::Phase::armed, core::PhaseReason::gyro_failed_before_control);
  EXPECT_EQ(verdict_of(deaf.flight).outcome, Outcome::no_control);
  EXPECT_EQ(numbers(verdict_of(deaf.flight)), Numbers{"0.30"});
  EXPECT_TRUE(says(verdict_of(deaf.flight), flight::display_name(core::PhaseReason::gyro_failed_before_control)));
}

std::string sheet_of(const flight::Flight& flight) {
  const Figures f = figures(flight);
  return result::text(answer(flight, f, verdict(flight, f)));
}

/// Two canards that no command moves, from 1 s to 4.3 s; each is given half a second to return.
void jam(flight::Flight& flight) {
  for (flight::Row& row : flight.rows) {
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      const auto trim_rad = static_cast<double>(flight.plan.canards.each[i].trim.radians());
      const double away_deg = row.time_s < 1.0 || row.time_s > 4.3 ? 0.0 : i == 1 ? 25.0 : i == 3 ? -3.0 : 0.4;
      row.commands_rad[i] = trim_rad;
      row.encoders_rad[i] = trim_rad + text::radians(away_deg);
    }
  }
}

// A command to trim is no proof that they stand there.
TEST(ControlEnd, SaysWhichCanardsDidNotStandAtTrimAfterIt) {
  SyntheticFlight made;
  made.end_control(3.0, core::PhaseReason::canard_fault);
  EXPECT_TRUE(fantail::says(sheet_of(made.flight), "a canard fault; canards commanded to trim\n"));
  jam(made.flight);
  EXPECT_TRUE(
      fantail::says(sheet_of(made.flight),
                    "a canard fault; canards commanded to trim; by encoder, canard 2 stood up to 25.0 deg away, "
                    "canard 4 stood up to 3.0 deg away\n"))
      << sheet_of(made.flight);
  SyntheticFlight late;
  late.end_control(4.0, core::PhaseReason::apogee);
  jam(late.flight);
  EXPECT_FALSE(fantail::says(sheet_of(late.flight), "by encoder")) << "they came back in half a second";
}

TEST(ControlEnd, SaysWhichCanardsDidNotStandAtTrimWhileTheyWaited) {
  SyntheticFlight made;
  made.never_controlled(3.0, core::Phase::finished, core::PhaseReason::canard_fault);
  made.flight.events.dormant_s = 0.6;
  made.flight.events.control_end_s = 3.0;
  jam(made.flight);
  EXPECT_TRUE(
      fantail::says(sheet_of(made.flight),
                    "a canard fault; canards commanded to trim; by encoder, canard 2 stood up to 25.0 deg away"));
  EXPECT_FALSE(fantail::says(sheet_of(made.flight), "stayed at trim"));
}

// It left the guide at 0.5 s of 1.5; of a plan that no condition of is known to be unmet, none is named.
TEST(ControlEnd, WhatOfThePlanAFastRocketDidNotReachIsNamed) {
  using core::PhaseReason;
  SyntheticFlight fast;
  fast.flight.plan.guide = {
      .length_m = 4.0F, .clearance_m = 2.0F, .minimum_speed_m_s = 40.0F, .clearance_time = core::from_seconds(1.5F)};
  fast.never_controlled(1.7, core::Phase::armed, PhaseReason::guide_not_cleared_in_time);
  for (flight::Row& row : fast.flight.rows) {
    row.height_m = row.time_s <= 1.7 ? 30.0 : 90.0;
    row.speed_m_s = row.time_s <= 1.7 ? 33.0 : 70.0;
  }
  fast.flight.events.guide_clear_s = 0.5;
  const Verdict slow = verdict_of(fast.flight);
  EXPECT_TRUE(says(slow, "guide.minimum_speed_m_s")) << slow.text;
  EXPECT_EQ(numbers(slow), (Numbers{"1.5", "1.70", "33.0", "40"})) << slow.text;
  flight::Flight logged = fast.flight;
  logged.events.guide_clear_s.reset();
  EXPECT_EQ(verdict_of(logged).text, slow.text) << "a log does not know when it left the guide";

  fast.flight.plan.guide.minimum_speed_m_s = 17.0F;
  const Verdict shaken = verdict_of(fast.flight);
  EXPECT_TRUE(says(shaken, "at once")) << shaken.text;
  EXPECT_EQ(numbers(shaken), (Numbers{"1.5", "1.70"})) << shaken.text;

  fast.flight.plan.guide.length_m = 100.0F;
  const Verdict near = verdict_of(fast.flight);
  EXPECT_TRUE(says(near, "guide.length_m")) << near.text;
  EXPECT_EQ(numbers(near), (Numbers{"1.5", "1.70", "30.0", "102"})) << near.text;
  fast.flight.events.guide_clear_s.reset();
  EXPECT_TRUE(says(verdict_of(fast.flight), "did not clear the guide")) << verdict_of(fast.flight).text;
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
    const Verdict v = verdict_of(synthetic.flight);
    EXPECT_EQ(v.outcome, Outcome::no_control);
    return v;
  };
  const flight::PhaseChange armed{-9.0, Phase::armed, PhaseReason::armed_by_switch_and_command};
  const flight::PhaseChange launched{0.13, Phase::launched, PhaseReason::launch_detected};
  const flight::PhaseChange back{1.62, Phase::armed, PhaseReason::guide_not_cleared_in_time};
  // At 4.73 s the rocket reports that it has flown.
  const Verdict chuff = after({armed, launched, back});
  EXPECT_EQ(numbers(chuff), (Numbers{"1.5", "1.62", "4.73"})) << chuff.text;
  EXPECT_TRUE(says(chuff, "guide")) << chuff.text;
  EXPECT_EQ(after({launched, back}).text, chuff.text) << "as a log has it that begins with the push";
  EXPECT_EQ(numbers(after({armed})), Numbers{"4.73"});
  EXPECT_FALSE(says(after({armed}), "guide"));
  EXPECT_EQ(after({}).text, after({armed}).text);
  const Verdict moved = after({armed, {-2.0, Phase::armed, PhaseReason::moved_without_launch}});
  EXPECT_EQ(numbers(moved), (Numbers{"-2.00", "4.73"})) << moved.text;
  EXPECT_TRUE(says(moved, "moved")) << moved.text;
  const Verdict in_flight = after({armed, {2.5, Phase::armed, PhaseReason::moved_without_launch}});
  EXPECT_EQ(numbers(in_flight), (Numbers{"2.50", "4.73"})) << in_flight.text;
  EXPECT_FALSE(says(in_flight, "moved")) << in_flight.text;
  const Verdict rested = after({armed, launched, back, {3.0, Phase::armed, PhaseReason::rested}});
  EXPECT_EQ(numbers(rested), (Numbers{"3.00", "4.73"})) << rested.text;
  EXPECT_TRUE(says(rested, "rested")) << rested.text;
}

TEST(ControlEnd, OfATableThatHasNoControlOnlyItsRowsAreTold) {
  SyntheticFlight table;
  table.flight.seed.reset();
  const auto of_rows = [&table](std::size_t begin, std::size_t end, std::optional<core::Phase> all) {
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
    const Verdict v = verdict_of(part);
    EXPECT_EQ(v.outcome, Outcome::no_control) << v.text;
    return v;
  };
  EXPECT_TRUE(says(of_rows(0, 600, core::Phase::safe), "Safe"));
  EXPECT_TRUE(says(of_rows(0, 600, {}), "Armed") && says(of_rows(0, 600, {}), "every"));
  EXPECT_TRUE(says(of_rows(0, 1000, {}), "Launched") && says(of_rows(0, 1000, {}), "last"));
  EXPECT_TRUE(says(of_rows(4000, 5000, core::Phase::finished), "Finished"));
}

}  // namespace
}  // namespace fantail::report
