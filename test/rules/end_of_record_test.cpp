// SPDX-License-Identifier: MIT
// Records of flights in which control ended before apogee.
#include "rules/logged_flight.hpp"

namespace fantail::rules::logged {
namespace {

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
    expect_open(without(4.99, 30.0, ended_early()), name, "the record ends at 4.99 s");
  }
  expect_open(without(12.0, 13.0, ended_early()), "largest_mach", "the record misses 12.00 to 13.00 s");
}

}  // namespace
}  // namespace fantail::rules::logged
