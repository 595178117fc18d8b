// SPDX-License-Identifier: MIT
// A gate that closes under control.
#include <algorithm>

#include "dormant_flight.hpp"
#include "report/answer.hpp"
#include "report/sections.hpp"
#include "test.hpp"

namespace fantail::report {
namespace {

using enum core::Phase;

/// Control from 1.0 s, the gate closed from 2.0 s to 2.2 s.
SyntheticFlight interrupted() {
  SyntheticFlight made = dormant_flight();
  made.each_controlled(
      [](flight::Row& row) { row.phase = row.time_s > 1.9995 && row.time_s < 2.1995 ? dormant : controlling; });
  made.flight.phase_changes.push_back({2.0, dormant, core::PhaseReason::gate_closed_again});
  made.flight.phase_changes.push_back({2.2, controlling, core::PhaseReason::gate_open});
  return made;
}

TEST(Gate, ThatClosesAgainInterruptsControl) {
  SyntheticFlight made = interrupted();
  // Off by 50 deg for a second after each beginning.
  made.each_controlled([](flight::Row& row) {
    const bool begins = row.time_s < 1.9995 || (row.time_s > 2.1 && row.time_s < 3.1995);
    row.truth->roll_angle_rad = row.roll_angle_rad = text::radians(begins ? 40.0 : settles_deg);
  });
  const Figures f = figures(made.flight);
  EXPECT_EQ(f.opening.closings, 1U);
  EXPECT_NEAR(f.control_time_s.value(), 3.5 - 0.201, 1e-6) << "between two ticks that are 0.201 s apart";
  EXPECT_NEAR(f.judged_time_s.value(), 1.3, 1e-6);
  EXPECT_EQ(verdict_of(made.flight).outcome, Outcome::held) << verdict_of(made.flight).text;
  const std::string page = result::text(answer(made.flight, f, verdict(made.flight, f)));
  EXPECT_NE(page.find("gate closes"), std::string::npos);
  EXPECT_NE(page.find("the motor pushes again"), std::string::npos);
  EXPECT_NE(page.find("gate reopens"), std::string::npos);
}

// Half a turn a second throughout: dormant for 0.4 s and 0.2 s, under control from 1.0 s to the tick before 2.0 s and
// from 2.2 s to 4.5 s. What the rocket makes in a pause counts as dormant alone.
TEST(Gate, ThatClosesAgainSharesTheTurnsBetweenControlAndDormancy) {
  SyntheticFlight made = interrupted();
  for (flight::Row& row : made.flight.rows) {
    row.roll_angle_rad = row.truth->roll_angle_rad = text::radians(180.0 * row.time_s);
    made.flight.without_control.push_back({row.time_s, text::radians(-720.0 * row.time_s), 0.0});
  }
  const Figures f = figures(made.flight);
  EXPECT_NEAR(f.opening.dormant_turns.value(), 0.5 * (0.4 + 0.2), 1e-9);
  EXPECT_NEAR(f.roll_turns.value(), 0.5 * (0.999 + 2.3), 1e-9);
  EXPECT_NEAR(f.roll_turns_without_control.value(), -2.0 * (0.999 + 2.3), 1e-9);
}

TEST(Gate, ThatReopensLetsCaptureChooseAgain) {
  SyntheticFlight made = interrupted();
  made.flight.plan.controller.entry = core::ControlEntry::capture;
  made.each_controlled([](flight::Row& row) {
    const bool again = row.time_s > 2.1;
    const double since_s = row.time_s - (again ? 2.2 : opens_s);
    row.reference_rad = text::radians(again ? -720.0 : -360.0);
    row.roll_angle_rad = row.truth->roll_angle_rad =
        row.reference_rad + text::radians(settles_deg + (since_s < (again ? 0.5 : 0.25) ? 50.0 : 0.0));
    row.truth->speed_m_s = 50.0;
  });
  const Figures f = figures(made.flight);
  EXPECT_EQ(f.capture.turn, -1.0);
  EXPECT_NEAR(f.capture.after_s.value(), 0.25, 1e-6);
  ASSERT_EQ(f.reopenings.size(), 1U);
  EXPECT_NEAR(f.reopenings[0].time_s, 2.2, 1e-6);
  EXPECT_EQ(f.reopenings[0].capture.turn, -2.0);
  EXPECT_NEAR(f.reopenings[0].capture.after_s.value(), 0.5, 1e-6);
  const std::vector<std::string> beside = beside_the_verdict(made.flight, f, verdict(made.flight, f));
  EXPECT_NE(std::ranges::find(beside,
                              "The gate closed and reopened at 2.20 s. Capture chose turn -2; roll was captured "
                              "in 0.50 s."),
            beside.end());
}

TEST(Gate, ThatClosesForGoodEndsControlThen) {
  SyntheticFlight made = interrupted();
  made.each_controlled([](flight::Row& row) { row.phase = row.time_s > 2.0 ? dormant : controlling; });
  made.flight.events.control_end_s = 2.0;
  made.flight.phase_changes.back() = {4.5, finished, core::PhaseReason::gate_never_opened};
  const Verdict v = verdict_of(made.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_TRUE(says(v,
                   "Control ended at 2.00 s, 2.50 s before apogee: the motor pushes again, and the plan's gate did "
                   "not open again."))
      << v.text;
}

}  // namespace
}  // namespace fantail::report
