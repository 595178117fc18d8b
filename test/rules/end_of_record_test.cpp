// SPDX-License-Identifier: MIT
// Records of flights in which control ended before apogee.
#include "records.hpp"

namespace fantail::rules {
namespace {

/// Its axis leans by a degree a second from lift-off on; control ends at the abort.
flight::Flight leaning() {
  flight::Flight log = whole();
  for (flight::Row& row : log.rows) {
    row.tilt_from_guide_rad = text::radians(std::max(0.0, row.time_s));
    const double away_rad = row.time_s >= 9.0 && row.time_s < 12.0 ? text::radians(3.0) : 0.0;
    for (std::size_t k = 0; k < core::canard_count; ++k) {
      const auto trim_rad = static_cast<double>(log.plan.canards.each[k].trim.radians());
      row.commands_rad[k] = row.encoders_rad[k] = trim_rad + away_rad;
    }
  }
  log.events.control_end_s = 12.0;
  log.phase_changes.back() = {12.0, core::Phase::finished, core::PhaseReason::aborted};
  return log;
}

TEST(Record, ShowsTheTiltUnderControl) {
  EXPECT_NEAR(number_of(leaning(), "tilt_off_trim_deg").low, 11.99, 0.001);
  EXPECT_EQ(number_of(leaning(), "tilt_off_trim_deg").low, number_of(leaning(), "tilt_off_trim_deg").high);
  expect_open(with_hole(10.0, 11.0, leaning()), "tilt_off_trim_deg", "the record misses 10.00 to 11.00 s");
  flight::Flight table = leaning();
  for (flight::Row& row : table.rows) {
    row.tilt_from_guide_rad.reset();
  }
  expect_open(table, "tilt_off_trim_deg", "no attitude at 9.00 s");
}

TEST(Record, ShowsWhetherCanardsStandAtTrimAfterAnAbort) {
  EXPECT_EQ(figure(leaning(), "off_trim_after_abort").known, Known{false});
  flight::Flight stuck = leaning();
  for (flight::Row& row : stuck.rows) {
    *row.encoders_rad[1] += row.time_s > 11.0 ? text::radians(2.0) : 0.0;
  }
  EXPECT_EQ(figure(stuck, "off_trim_after_abort").known, Known{true});
  EXPECT_NE(figure(stuck, "off_trim_after_abort").how.find("abort at 12.00 s; encoder of canard 2"), std::string::npos);
  EXPECT_FALSE(figure(with_hole(14.0, 15.0, leaning()), "off_trim_after_abort").known);
  EXPECT_FALSE(figure(with_hole(12.2, 30.0, leaning()), "off_trim_after_abort").known)
      << "the record ends with the abort";
  EXPECT_EQ(figure(whole(), "off_trim_after_abort").known, Known{false}) << "none came";
  EXPECT_FALSE(figure(with_hole(10.0, 11.0), "off_trim_after_abort").known) << "it may have come in the hole";
}

/// A canard fault ended it in the middle of the burn; the avionics go on to record.
flight::Flight ended_early() {
  flight::Flight log = whole();
  log.events.control_start_s.reset();
  log.events.control_end_s = 3.0;
  log.phase_changes.back() = {3.0, core::Phase::finished, core::PhaseReason::canard_fault};
  for (flight::Row& row : log.rows) {
    row.phase = row.time_s < 0.2 ? core::Phase::armed : row.time_s < 3.0 ? core::Phase::dormant : core::Phase::finished;
  }
  return log;
}

TEST(Record, GoesOnToItsGreatestHeightWhereControlEndedBefore) {
  for (const char* name : {"top_speed_m_s", "largest_mach", "max_q_s", "apogee_m", "burnout_s"}) {
    EXPECT_EQ(figure(ended_early(), name).known, figure(whole(), name).known) << name;
  }
  for (const char* name : {"top_speed_m_s", "largest_mach", "max_q_s", "apogee_m", "burnout_s"}) {
    expect_open(with_hole(4.99, 30.0, ended_early()), name, "the record ends at 4.99 s");
  }
  expect_open(with_hole(12.0, 13.0, ended_early()), "largest_mach", "the record misses 12.00 to 13.00 s");
}

}  // namespace
}  // namespace fantail::rules
