// SPDX-License-Identifier: MIT
// What comes before control, how it begins, and what the verdict makes of it.
#include "report/beginning.hpp"

#include <algorithm>
#include <cmath>

#include "dormant_flight.hpp"
#include "report/answer.hpp"
#include "report/sections.hpp"
#include "test.hpp"

namespace fantail::report {
namespace {

using enum core::Phase;

/// Roll under control: `off_deg(t)` from where the law settles, t since control start.
void roll(SyntheticFlight& made, const std::function<double(double)>& off_deg) {
  made.each_controlled([&](flight::Row& row) {
    row.roll_angle_rad = text::radians(settles_deg + off_deg(row.time_s - opens_s));
    row.truth->roll_angle_rad = row.roll_angle_rad;
    row.speed_m_s = row.truth->speed_m_s = 50.0;
  });
}

TEST(Neutral, IsTheLargestDistanceFromTrimFromArmingToControl) {
  SyntheticFlight made = dormant_flight();
  made.flight.plan.canards.each[1].trim = core::Angle::from_degrees(2.0F);
  for (flight::Row& row : made.flight.rows) {
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      const double trim_rad = i == 1 ? text::radians(2.0) : 0.0;
      row.commands_rad[i] = trim_rad + text::radians(row.phase == controlling ? 9.0 : 0.0);
      row.encoders_rad[i] = trim_rad + text::radians(row.phase == controlling ? 9.0 : 0.0);
    }
  }
  made.flight.rows[100].phase = safe;  // before this, at -0.4 s, it was armed once already
  made.flight.rows[50].encoders_rad[0] = text::radians(8.0);
  made.flight.rows[1200].encoders_rad[1] = text::radians(1.7);  // at 0.7 s
  const Neutral n = figures(made.flight).neutral;
  EXPECT_NEAR(n.from_s.value(), -0.399, 1e-9);
  EXPECT_NEAR(n.until_s.value(), 0.999, 1e-9);
  EXPECT_NEAR(text::degrees(n.command_rad.value()), 0.0, 1e-6);
  EXPECT_NEAR(text::degrees(n.encoder_rad.value()), 0.3, 1e-6);
  EXPECT_EQ(n.unread_s, 0.0);

  for (int i = 1300; i < 1350; ++i) {
    made.flight.rows[static_cast<std::size_t>(i)].encoders_rad[3].reset();
  }
  EXPECT_NEAR(figures(made.flight).neutral.unread_s, 0.05, 1e-9);
  made.flight.known.plan = false;
  EXPECT_FALSE(figures(made.flight).neutral.command_rad) << "trims are in the plan";
}

TEST(Opening, IsTheStateAtControlStartAndTheTurnsBeforeIt) {
  SyntheticFlight made = dormant_flight();
  for (flight::Row& row : made.flight.rows) {  // 2 turns a second backwards from 0.6 s on
    row.roll_angle_rad = row.time_s < 0.6 ? 0.0 : text::radians(-720.0 * (row.time_s - 0.6));
    row.roll_rate_rad_s = text::radians(-720.0);
    row.speed_m_s = 50.0;
    row.truth->roll_angle_rad = row.roll_angle_rad + 1.0;  // the truth counts from the pad
    row.truth->roll_rate_rad_s = text::radians(-719.0);
    row.truth->speed_m_s = 51.0;
  }
  const Opening o = figures(made.flight).opening;
  EXPECT_NEAR(o.dormant_turns.value(), -0.8, 1e-9);
  EXPECT_NEAR(text::degrees(o.roll_angle_rad.value()), -288.0, 1e-9);
  EXPECT_NEAR(text::degrees(o.roll_rate_rad_s.value()), -719.0, 1e-9);
  EXPECT_EQ(o.speed_m_s, 51.0);
  EXPECT_EQ(o.closings, 0U);
  EXPECT_FALSE(figures(SyntheticFlight{}.flight).opening.dormant_turns) << "it did not wait";
}

flight::Flight without(double from_s, double to_s) {
  flight::Flight flight = dormant_flight().flight;
  std::erase_if(flight.rows, [&](const flight::Row& row) { return row.time_s > from_s && row.time_s < to_s; });
  return flight;
}

// The first row behind the hole is of another time.
TEST(Opening, IsNotKnownWhereAHoleHidesTheStartOfControl) {
  const Figures f = figures(without(0.8, 1.5));
  EXPECT_TRUE(f.misses_control_start);
  EXPECT_FALSE(f.control_start_height_m);
  EXPECT_EQ(f.opening, Opening{});
  EXPECT_EQ(f.capture, Capture{});
  EXPECT_FALSE(figures(without(0.5, 0.8)).opening.dormant_turns) << "where the wait began";
  EXPECT_TRUE(figures(without(0.5, 0.8)).opening.roll_angle_rad);
  EXPECT_TRUE(figures(without(0.7, 0.9)).opening.dormant_turns) << "the angle goes on behind a hole";
  EXPECT_FALSE(figures(without(0.95, 1.02)).misses_control_start) << "a small one";
}

TEST(Neutral, CountsTheTimeThatIsNotOnRecord) {
  EXPECT_NEAR(figures(without(0.7, 0.9)).neutral.missing_s, 0.2, 1e-9);
  const double unread_s = figures(dormant_flight().flight).neutral.unread_s;  // it has no encoders
  EXPECT_NEAR(figures(without(0.7, 0.9)).neutral.unread_s, unread_s - 0.2, 1e-9) << "counted once";
  EXPECT_EQ(figures(dormant_flight().flight).neutral.missing_s, 0.0);
}

// 100 deg exp(-t / 0.2 s) is 10 deg after 0.2 s ln 10 = 0.4605 s: the first millisecond after that is 0.461.
TEST(Capture, CountsUntilTheRollStaysNearWhereTheLawSettles) {
  SyntheticFlight made = dormant_flight();
  roll(made, [](double t) { return 100.0 * std::exp(-t / 0.2); });
  made.each_controlled([](flight::Row& row) { row.saturated = row.time_s < opens_s + 0.2305; });
  const Capture c = figures(made.flight).capture;
  EXPECT_NEAR(c.after_s.value(), 0.461, 1e-6);
  EXPECT_NEAR(c.saturated_fraction.value(), 231.0 / 461.0, 1e-9);
  EXPECT_NEAR(c.watched_s.value(), 1.461, 1e-6) << "a second more than it took";
  EXPECT_FALSE(c.turn);
}

// 100 deg/s and 0 deg off; it comes to 100 * 0.2 / e = 7.4 deg.
TEST(Capture, OfARollThatNeverLeavesItsRestIsNotSaidInSeconds) {
  SyntheticFlight made = dormant_flight();
  roll(made, [](double t) { return 100.0 * t * std::exp(-t / 0.2); });
  const Figures f = figures(made.flight);
  EXPECT_EQ(f.capture.after_s, 0.0);
  const std::string page = result::text(answer(made.flight, f, verdict(made.flight, f)));
  EXPECT_TRUE(fantail::says(page, "Roll was within 10 deg of its rest as control began, and stayed there."));
  EXPECT_FALSE(fantail::says(page, "captured in 0.00 s"));
}

TEST(Capture, IsNotWhatTheRollPassesThrough) {
  SyntheticFlight made = dormant_flight();
  roll(made, [](double t) { return 60.0 * (t - 1.0); });
  const Capture c = figures(made.flight).capture;
  EXPECT_FALSE(c.after_s);
  EXPECT_NEAR(c.watched_s.value(), 3.5, 1e-6);
}

TEST(Capture, IsWatchedInFlightUntilTheAirIsTooSlow) {
  for (const auto& [slow_s, captured] : {std::pair{0.7, false}, {0.9, true}}) {
    SyntheticFlight made = dormant_flight();
    roll(made, [](double t) { return t < 0.3 ? 50.0 : 0.0; });
    made.each_controlled([slow_s](flight::Row& row) {
      row.truth->speed_m_s = row.time_s < opens_s + slow_s ? 50.0 : flight::slowest_held_m_s - 1.0;
    });
    EXPECT_EQ(figures(made.flight).capture.after_s.has_value(), captured) << slow_s;
  }
}

TEST(Capture, NeedsHalfASecondWhereTheReferenceChanges) {
  for (const auto& [step_s, captured] : {std::pair{0.7, false}, {0.9, true}}) {
    SyntheticFlight made = dormant_flight();
    roll(made, [](double t) { return t < 0.3 ? 50.0 : 0.0; });
    made.each_controlled(
        [step_s](flight::Row& row) { row.reference_rad = row.time_s < opens_s + step_s ? 0.0 : text::radians(-20.0); });
    EXPECT_EQ(figures(made.flight).capture.after_s.has_value(), captured) << step_s;
  }
}

TEST(Capture, OfALogCountsFromWhereTheRollCameToRest) {
  SyntheticFlight made = dormant_flight();
  roll(made, [](double t) { return 100.0 * std::exp(-t / 0.2); });
  made.flight.seed.reset();
  for (flight::Row& row : made.flight.rows) {
    row.truth.reset();
  }
  // From 1 s to 2 s the mean of 100 exp(-t / 0.2) is 20 (exp(-5) - exp(-10)) = 0.134 deg: near until 10.134 deg, after
  // 0.2 ln(100 / 10.134) = 0.458 s.
  EXPECT_NEAR(figures(made.flight).capture.after_s.value(), 0.458, 0.0011);
  roll(made, [](double t) { return 200.0 * t; });
  EXPECT_FALSE(figures(made.flight).capture.after_s) << "it never rested";
}

TEST(Capture, LeavesLessToTheHoldError) {
  SyntheticFlight made = dormant_flight();
  roll(made, [](double t) { return t < 1.1 ? 50.0 : 0.0; });
  EXPECT_EQ(verdict_of(made.flight).outcome, Outcome::not_held) << "as published a second is left out";
  made.flight.plan.controller.entry = core::ControlEntry::capture;
  const Verdict v = verdict_of(made.flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_TRUE(says(v, "after the first 1.2 s of control"));
  EXPECT_NEAR(figures(made.flight).judged_time_s.value(), 2.3, 1e-6);
  roll(made, [](double t) { return t < 1.3 ? 50.0 : 0.0; });
  EXPECT_EQ(verdict_of(made.flight).outcome, Outcome::not_held);
}

TEST(Gate, ThatStaysClosedIsNoFailure) {
  SyntheticFlight made = dormant_flight();
  made.each_controlled([](flight::Row& row) { row.phase = dormant; });
  made.flight.events.control_start_s.reset();
  made.flight.plan.dormancy.until = core::DormantUntil::height;
  made.flight.plan.dormancy.height_m = 1500.0F;
  made.flight.phase_changes.back() = {4.5, finished, core::PhaseReason::gate_never_opened};
  for (flight::Row& row : made.flight.rows) {
    row.truth->height_m = 421.4 * std::max(0.0, row.time_s) / 4.5;
  }
  const Verdict v = verdict_of(made.flight);
  EXPECT_EQ(v.outcome, Outcome::no_control);
  EXPECT_EQ(answer(v), result::Answer::undecided);
  EXPECT_EQ(v.text,
            "Control never began: apogee at 421 m, the gate opens at 1500 m. The canards were commanded to trim, as "
            "the plan demands.");
  made.flight.plan.dormancy.height_m = 400.0F;  // the low end of the error did not reach it
  EXPECT_TRUE(says(verdict_of(made.flight), "low end"));
  made.flight.plan.dormancy.until = core::DormantUntil::burn_out;
  EXPECT_TRUE(says(verdict_of(made.flight), "the plan waits for burn-out, and that did not come before 4.50 s"));

  flight::Flight log = made.flight;
  log.plan.dormancy.until = core::DormantUntil::height;
  log.plan.dormancy.height_m = 1500.0F;
  log.events.apogee_s.reset();
  for (flight::Row& row : log.rows) {
    row.truth.reset();
    row.height_m = 421.4 * std::max(0.0, row.time_s) / 4.5;
  }
  EXPECT_TRUE(says(verdict_of(log), "the measured height reached 421 m, the gate opens at 1500 m"));

  made.flight.phase_changes.back().reason = core::PhaseReason::aborted;
  EXPECT_EQ(verdict_of(made.flight).text,
            "No control: aborted by the abort input (at 4.50 s), while the canards waited for burn-out.");
  EXPECT_EQ(answer(verdict_of(made.flight)), result::Answer::no);
  made.flight.plan.dormancy.until = core::DormantUntil::burn_out_and_height;
  made.flight.plan.dormancy.height_m = 1500.0F;
  EXPECT_TRUE(says(verdict_of(made.flight), "waited for burn-out and 1500 m, above the apogee of 421 m."));
  made.flight.plan.dormancy.height_m = 400.0F;
  EXPECT_TRUE(says(verdict_of(made.flight), "waited for burn-out and 400 m."));
  made.flight.plan.dormancy.until = core::DormantUntil::burn_out;
  made.flight.phase_changes.pop_back();
  EXPECT_EQ(verdict_of(made.flight).text,
            "No control: the record ends while the canards waited for burn-out, from 0.60 s on.");
}

using Words = std::vector<std::string>;
Words labels_of(const flight::Flight& flight) {
  Words labels;
  std::ranges::transform(charts(flight).charts.at(0).levels, std::back_inserter(labels), &page::Level::label);
  return labels;
}

TEST(Gate, OnATrajectoryTheMotorMayStillBurnWhereItsThrustIsBelowTheDrag) {
  SyntheticFlight made = dormant_flight();
  made.flight.events.burnout_s = 0.9;
  const auto said = [&made] {
    const Figures f = figures(made.flight);
    return result::text(answer(made.flight, f, verdict(made.flight, f)));
  };
  EXPECT_FALSE(fantail::says(said(), "burned"));
  EXPECT_TRUE(fantail::says(said(), "thrust is over"));
  made.flight.path_frame = flight::PathFrame::plane;
  EXPECT_TRUE(
      fantail::says(said(), "The motor may still have burned then: the trajectory does not show thrust below drag."));
  EXPECT_FALSE(fantail::says(said(), "thrust is over"));
  made.flight.events.burnout_s = 1.25;
  EXPECT_TRUE(fantail::says(said(), "The motor still burned: its thrust ended 0.250 s later."));
}

TEST(Gate, ThatControlNeverBeganIsMarkedAsTheEventTableHasIt) {
  SyntheticFlight made;
  made.never_controlled(3.0, finished, core::PhaseReason::tilted_too_far);
  made.flight.events.dormant_s = 0.6;
  made.flight.events.control_end_s = 3.0;
  EXPECT_EQ(labels_of(made.flight), (Words{"lift-off", "detected", "dormant", "control never began", "apogee"}));
}

TEST(Gate, IsShadedAndMarkedAndAStepIsNamedByThePlansAngle) {
  SyntheticFlight made = dormant_flight();
  made.flight.plan.controller.entry = core::ControlEntry::capture;
  made.each_controlled([](flight::Row& row) { row.reference_rad = text::radians(row.time_s < 3.0 ? -360.0 : -380.0); });
  EXPECT_EQ(figures(made.flight).capture.turn, -1.0);
  const page::Chart roll_chart = charts(made.flight).charts.at(0);
  EXPECT_EQ(labels_of(made.flight),
            (Words{"lift-off", "detected", "dormant", "gate opens", "step to \u221220\u00b0", "apogee"}));
  EXPECT_EQ(roll_chart.series.at(0).name, "reference R, from turn \u22121 (\u2212360 deg)");
  const auto shaded = std::ranges::find(roll_chart.shaded_ranges, "Dormant", &page::ShadedRange::label);
  ASSERT_NE(shaded, roll_chart.shaded_ranges.end());
  EXPECT_EQ(shaded->role, page::Role::waiting);
  EXPECT_NEAR(shaded->begin, 0.6, 1e-9);
}

TEST(Gate, ACameraSeesTheConingOfAWaitToo) {
  SyntheticFlight made = dormant_flight();
  for (flight::Row& row : made.flight.rows) {
    const bool cones = row.time_s > 0.7 && row.time_s < 0.9;
    row.truth->geometric_roll_rad = row.truth->roll_angle_rad + text::radians(cones ? 5.0 : 0.0);
  }
  EXPECT_NEAR(text::degrees(figures(made.flight).camera_roll->largest_rad), 5.0, 1e-9);
}

}  // namespace
}  // namespace fantail::report
