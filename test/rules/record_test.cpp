// SPDX-License-Identifier: MIT
#include "rules/record.hpp"

#include "rules/judge.hpp"
#include "rules/logged_flight.hpp"

namespace fantail::rules::logged {
namespace {

TEST(Record, OfAWholeFlightStatesEveryFigure) {
  for (const auto& [name, value] : {std::pair{"top_speed_m_s", 200.0},
                                    {"max_q_s", 8.0},
                                    {"apogee_m", 1800.0},
                                    {"burnout_s", 8.08},
                                    {"control_start_s", 9.0},
                                    {"control_start_height_m", 1395.0},
                                    {"left_trim_s", 9.0},
                                    {"canard_before_control_deg", 0.0}}) {
    EXPECT_NEAR(number(whole(), name).low, value, 0.03) << name;
    EXPECT_EQ(number(whole(), name).low, number(whole(), name).high) << name;
  }
  EXPECT_TRUE(control_in_log(whole()).of_subject.empty());
}

TEST(Record, ThatMissesAPartOfTheAscentLeavesExtremesOpenAndSaysWhatItMisses) {
  for (const char* name : {"top_speed_m_s", "largest_mach", "apogee_m", "max_q_s", "burnout_s", "left_trim_s"}) {
    expect_open(without(4.0, 8.5), name, "the record misses 4.00 to 8.50 s");
  }
  EXPECT_NEAR(number(without(4.0, 8.5), "max_q_s").low, 4.0, 1e-6);
  EXPECT_NEAR(number(without(4.0, 8.5), "max_q_s").high, 8.5, 0.011);
  EXPECT_NEAR(number(without(4.0, 8.5), "burnout_s").low, 4.0, 0.1);
}

TEST(Record, WithASmallHoleIsWhole) {
  EXPECT_EQ(number(without(4.0, 4.09), "max_q_s"), number(whole(), "max_q_s"));
  EXPECT_EQ(figure(without(4.0, 4.09), "top_speed_m_s").how.find("misses"), std::string::npos);
}

TEST(Record, WithAHoleAfterTheAscentIsWhole) {
  EXPECT_EQ(number(without(18.5, 19.5), "top_speed_m_s"), number(whole(), "top_speed_m_s"));
}

TEST(Record, WithAHoleAfterBurnOutKnowsBurnOut) {
  EXPECT_EQ(number(without(12.0, 13.0), "burnout_s"), number(whole(), "burnout_s"));
  expect_open(without(12.0, 13.0), "top_speed_m_s", "the record misses 12.00 to 13.00 s");
}

TEST(Record, ThatBeginsInTheMiddleStatesNoExtreme) {
  const flight::Flight late = without_start(-2.0, 9.5);
  for (const char* name : {"top_speed_m_s", "max_q_s", "burnout_s", "left_trim_s", "canard_before_control_deg"}) {
    expect_open(late, name, "the record misses 0.00 to 9.50 s");
  }
  EXPECT_FALSE(figure(late, "control_start_s").known);
}

TEST(Record, ThatEndsUnderThrustSaysWhereItEnds) {
  flight::Flight cut = without_start(4.99, 30.0);
  cut.events.control_end_s.reset();
  cut.phase_changes.clear();
  for (const char* name : {"top_speed_m_s", "largest_mach", "max_q_s", "burnout_s"}) {
    expect_open(cut, name, "the record ends at 4.99 s");
  }
  EXPECT_EQ(control_in_log(cut).of_subject, ", which does not show whether control began");
}

TEST(Record, OfTheTruthThatEndsUnderThrustSaysSoToo) {
  flight::Flight cut = without_start(4.99, 30.0);
  cut.events.control_end_s.reset();
  for (flight::Row& row : cut.rows) {
    row.truth = flight::Truth{.height_m = row.height_m, .speed_m_s = row.speed_m_s};
  }
  expect_open(cut, "largest_mach", "the record ends at 4.99 s");
}

TEST(Record, ThatMissesTheBeginOfControlDoesNotSayThatItNeverBegan) {
  const flight::Flight log = without_start(8.5, 10.0);
  for (const char* name : {"control_start_s", "control_start_height_m"}) {
    EXPECT_FALSE(figure(log, name).known) << name;
    EXPECT_EQ(figure(log, name).how, "the record misses 8.50 to 10.00 s, so it does not show when control began");
  }
  EXPECT_EQ(control_in_log(log).of_subject, ", which does not show when control began");
}

TEST(Record, WhoseFirstRowAlreadyControlsDoesNotKnowWhenItBegan) {
  flight::Flight log = without(-2.0, 9.0);
  log.events.control_start_s = log.rows.front().time_s;
  EXPECT_FALSE(figure(log, "control_start_s").known);
  EXPECT_FALSE(figure(log, "control_start_height_m").known);
}

TEST(Record, WithoutHolesAndWithoutControlSaysThatItNeverBegan) {
  flight::Flight log = whole();
  log.events.control_start_s.reset();
  for (flight::Row& row : log.rows) {
    row.phase = row.phase == core::Phase::controlling ? core::Phase::launched : row.phase;
  }
  EXPECT_EQ(control_in_log(log).of_subject, ", in which control never began");
  EXPECT_EQ(figure(log, "control_start_s").how, "control never began");
}

TEST(Record, WithoutPhasesDoesNotKnowWhichAngleIsFromBeforeControl) {
  flight::Flight log = whole();
  log.known.phase = false;
  log.events.control_start_s.reset();
  EXPECT_FALSE(figure(log, "canard_before_control_deg").known);
}

TEST(Record, TakesNoCanardUnderControlForOneBeforeIt) {
  EXPECT_NEAR(number(without_start(8.5, 10.0), "canard_before_control_deg").low, 0.0, 0.01);
}

// A gate that closes again leaves dormant rows; without a gate every row before control is of the launch.
TEST(Record, LeavesOpenWhetherAHoleHidesAnEarlierSpellOfControl) {
  flight::Flight gated = whole();
  for (flight::Row& row : gated.rows) {
    row.phase = row.phase == core::Phase::launched && row.time_s > 1.0 ? core::Phase::dormant : row.phase;
  }
  EXPECT_EQ(number(gated, "control_start_s"), exactly(9.0));
  EXPECT_NEAR(number(without(4.0, 5.0, gated), "control_start_s").low, 4.0, 1e-6);
  EXPECT_EQ(number(without(4.0, 5.0, gated), "control_start_s").high, 9.0);
  expect_open(without(4.0, 5.0, gated), "control_start_height_m", "");
  expect_open(without(4.0, 5.0, gated), "left_trim_s", "misses 4.00 to 5.00 s");
  EXPECT_EQ(number(without(4.0, 5.0), "control_start_s"), exactly(9.0));
}

TEST(Record, WithAHoleStillShowsACanardThatLeftTrimUnderThrust) {
  flight::Flight log = whole();
  for (flight::Row& row : log.rows) {
    *row.encoders_rad[0] += row.time_s >= 2.0 && row.time_s < 3.0 ? text::radians(2.0) : 0.0;
  }
  log = without(4.0, 8.5, log);
  EXPECT_EQ(number(log, "left_trim_s"), exactly(2.0));
  EXPECT_GT(number(log, "burnout_s").low, 2.0);
  EXPECT_GT(number(log, "max_q_s").low, 2.0);
}

std::string_view boost_clause(const flight::Flight& log) {
  const std::vector<Judged> judged =
      judge(load_pack("irec"), {.what = "a log", .found = of_log(log, 8.0), .why_missing = "a log does not tell it"});
  return name(std::ranges::find(judged, "7.4.1 (flight)", [](const Judged& one) { return one.clause.id; })->outcome);
}

TEST(Record, DecidesAClauseOnlyAsFarAsItsRowsShowIt) {
  flight::Flight early = whole();
  for (flight::Row& row : early.rows) {
    *row.encoders_rad[0] += row.time_s >= 5.0 && row.time_s < 9.0 ? text::radians(2.0) : 0.0;
  }
  EXPECT_EQ(boost_clause(whole()), "PASS");
  EXPECT_EQ(boost_clause(early), "FAIL");
  EXPECT_EQ(boost_clause(without(4.0, 14.0, early)), "NOT KNOWN");
  EXPECT_EQ(boost_clause(without(6.0, 8.5, early)), "FAIL") << "the canard was seen to move under thrust";
  EXPECT_EQ(boost_clause(without(8.5, 10.0)), "PASS") << "the hole begins after burn-out";
}

// Without its motor nobody knows burn-out; the largest dynamic pressure may decide in its place.
TEST(Record, DoesNotPassByThePlansBurnTimeAlone) {
  flight::Flight log = whole();
  log.plan.dormancy.burn_time = core::Microseconds{8'000'000};
  const auto passes_by = [&](const char* condition) {
    Clause clause{.id = "x"};
    clause.passes_if = Expression::parse(condition, {.meaning_of = [](const std::string&) { return Meaning{}; }});
    return judge({.clauses = {clause}}, {.what = "a log", .found = of_log(log), .why_missing = "x"}).front().outcome;
  };
  EXPECT_EQ(passes_by("flight.left_trim_s >= flight.burnout_s"), Outcome::not_known);
  EXPECT_EQ(passes_by("flight.left_trim_s >= flight.burnout_s or flight.left_trim_s >= flight.max_q_s"), Outcome::pass);
}

TEST(Record, BeginsToMissAtTheLaunch) {
  EXPECT_EQ(missing_text(holes(without(-0.5, 3.0).rows, 0.0, 18.0)), "the record misses 0.00 to 3.00 s");
}

TEST(Record, WithManyHolesNamesTwo) {
  EXPECT_EQ(missing_text({{1.0, 2.0}, {3.0, endless_s}}), "the record misses 1.00 to 2.00 s and ends at 3.00 s");
  EXPECT_EQ(missing_text({{1.0, 2.0}, {3.0, 4.0}, {5.0, 6.0}}),
            "the record misses 1.00 to 2.00 s and 3.00 to 4.00 s and more");
  EXPECT_EQ(missing_text({}), "");
}

// What was recorded is then not what the rows have.
TEST(Record, WhoseReplayGivesSomethingElseStatesNoFigure) {
  flight::Flight log = whole();
  log.differing_ticks = 3;
  for (const auto& [name, found] : of_log(log)) {
    EXPECT_FALSE(found.known) << name;
    EXPECT_EQ(found.how, "3 ticks of the record differ from their replay") << name;
  }
}

TEST(Record, KnowsTheHeightsOfControlAndDepartureWithinTheErrorOfAnAccelerometer) {
  flight::Flight log = whole();
  for (flight::Row& row : log.rows) {
    row.height_error_m = 0.02 * row.height_m;
  }
  for (const char* name : {"control_start_height_m", "left_trim_height_m"}) {
    EXPECT_NEAR(number(log, name).low, 0.98 * 1395.0, 1e-6) << name;
    EXPECT_NEAR(number(log, name).high, 1.02 * 1395.0, 1e-6) << name;
    EXPECT_EQ(figure(log, name).how, "as the avionics estimated it, within the usual error of an accelerometer")
        << name;
  }
}

// What it states of a scenario follows from the simulation, whatever its avionics recorded.
TEST(Record, IsNotAskedAboutASimulatedScenario) {
  flight::Flight flown = without(4.0, 8.5);
  EXPECT_EQ(std::get<Number>(*of_flight(flown, {}).at("flight.top_speed_m_s").known).high,
            std::get<Number>(*of_flight(flown, {}).at("flight.top_speed_m_s").known).low);
}

}  // namespace
}  // namespace fantail::rules::logged
