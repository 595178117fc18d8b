// SPDX-License-Identifier: MIT
#include "rules/return_to_trim.hpp"

#include "rules/logged_flight.hpp"

namespace fantail::rules::logged {
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

TEST(ReturnToTrim, ShowsTheTiltUnderControl) {
  EXPECT_NEAR(number(leaning(), "tilt_off_trim_deg").low, 11.99, 0.001);
  EXPECT_EQ(number(leaning(), "tilt_off_trim_deg").low, number(leaning(), "tilt_off_trim_deg").high);
  expect_open(without(10.0, 11.0, leaning()), "tilt_off_trim_deg", "the record misses 10.00 to 11.00 s");
  flight::Flight table = leaning();
  for (flight::Row& row : table.rows) {
    row.tilt_from_guide_rad.reset();
  }
  expect_open(table, "tilt_off_trim_deg", "no attitude at 9.00 s");
}

TEST(ReturnToTrim, ShowsWhetherCanardsStandAtTrimAfterAnAbort) {
  EXPECT_EQ(figure(leaning(), "off_trim_after_abort").known, Known{false});
  flight::Flight stuck = leaning();
  for (flight::Row& row : stuck.rows) {
    *row.encoders_rad[1] += row.time_s > 11.0 ? text::radians(2.0) : 0.0;
  }
  EXPECT_EQ(figure(stuck, "off_trim_after_abort").known, Known{true});
  EXPECT_NE(figure(stuck, "off_trim_after_abort").how.find("abort at 12.00 s; encoder of canard 2"), std::string::npos);
  EXPECT_FALSE(figure(without(14.0, 15.0, leaning()), "off_trim_after_abort").known);
  EXPECT_FALSE(figure(without(12.2, 30.0, leaning()), "off_trim_after_abort").known)
      << "the record ends with the abort";
  EXPECT_EQ(figure(whole(), "off_trim_after_abort").known, Known{false}) << "none came";
  EXPECT_FALSE(figure(without(10.0, 11.0), "off_trim_after_abort").known) << "it may have come in the hole";
}

/// Finished by an abort at 5 s, while it was dormant; encoder 2 leaves its trim at 6 s, still under thrust.
flight::Flight aborted_early() {
  flight::Flight log = leaning();
  log.events.control_start_s.reset();
  log.events.control_end_s = 5.0;
  log.phase_changes.back().time_s = 5.0;
  for (flight::Row& row : log.rows) {
    row.phase = row.time_s < 0.2   ? core::Phase::armed
                : row.time_s < 5.0 ? core::Phase::launched
                                   : core::Phase::finished;
    for (std::size_t k = 0; k < core::canard_count; ++k) {
      row.commands_rad[k] = row.encoders_rad[k] = static_cast<double>(log.plan.canards.each[k].trim.radians());
    }
    *row.encoders_rad[1] += row.time_s >= 6.0 ? text::radians(5.0) : 0.0;
  }
  return log;
}

// The avionics' part is over then, and the canards are still on the rocket.
TEST(ReturnToTrim, IsLookedAtUpToApogeeThoughControlEndsBefore) {
  EXPECT_EQ(figure(aborted_early(), "left_trim").known, Known{true});
  EXPECT_EQ(number(aborted_early(), "left_trim_s"), exactly(6.0));
  EXPECT_NEAR(number(aborted_early(), "canard_before_control_deg").low, 5.0, 1e-6);
  EXPECT_EQ(figure(without(5.5, 7.0, aborted_early()), "left_trim").known, Known{true});
  EXPECT_FALSE(figure(without(5.5, 30.0, aborted_early()), "left_trim").known) << "the record ends before apogee";
}

TEST(ReturnToTrim, LeavesMotionKnownUpToApogeeThoughControlEndsBefore) {
  for (const char* name : {"top_speed_m_s", "largest_mach", "apogee_m", "max_q_s", "burnout_s"}) {
    EXPECT_EQ(number(aborted_early(), name), number(whole(), name)) << name;
  }
}

TEST(ReturnToTrim, IsNotKnownOfACanardWhoseEncoderIsSilentAfterAnAbort) {
  flight::Flight hidden = leaning();
  for (flight::Row& row : hidden.rows) {
    row.encoders_rad[1] = row.time_s > 13.0 ? std::nullopt : row.encoders_rad[1];
  }
  const Finding found = figure(hidden, "off_trim_after_abort");
  EXPECT_FALSE(found.known);
  EXPECT_NE(found.how.find("from 13.00 s on encoders or rows are missing"), std::string::npos) << found.how;
}

TEST(ReturnToTrim, IsNotKnownOfARecordThatEndsBetweenAbortAndApogee) {
  const Finding found = figure(without(14.0, 30.0, leaning()), "off_trim_after_abort");
  EXPECT_FALSE(found.known);
  EXPECT_NE(found.how.find("the record ends at 14.00 s"), std::string::npos) << found.how;
}

TEST(ReturnToTrim, IsKnownWhereTheRecordMissesOnlyATimeBeforeTheAbort) {
  EXPECT_EQ(figure(without(4.0, 5.0, leaning()), "off_trim_after_abort").known, Known{false});
}

// The angle after it may have been larger.
TEST(ReturnToTrim, LeavesTheAngleBeforeControlOpenBehindASilentEncoderAfterADeparture) {
  flight::Flight moved = whole();
  for (flight::Row& row : moved.rows) {
    *row.encoders_rad[1] += row.time_s >= 2.0 ? text::radians(0.6) : 0.0;
    row.encoders_rad[1] = row.time_s > 4.0 && row.time_s < 6.0 ? std::nullopt : row.encoders_rad[1];
  }
  EXPECT_NEAR(number(moved, "canard_before_control_deg").low, 0.6, 1e-6);
  EXPECT_EQ(number(moved, "canard_before_control_deg").high, endless_s);
}

/// The same as a simulation knows it: by its truth the axis leans twice as far, and every canard stands at its trim
/// where nothing is commanded.
flight::Flight simulated(bool can_tilt = true) {
  flight::Flight flown = leaning();
  flown.events.apogee_s = 18.0;
  for (flight::Row& row : flown.rows) {
    row.truth = flight::Truth{.height_m = row.height_m, .speed_m_s = row.speed_m_s};
    row.truth->tilt_from_guide_rad = can_tilt ? std::optional{2.0 * *row.tilt_from_guide_rad} : std::nullopt;
    auto& shafts_rad = row.truth->shafts_rad.emplace();
    std::ranges::transform(row.encoders_rad, shafts_rad.begin(), [](const auto& angle_rad) { return *angle_rad; });
  }
  return flown;
}
Finding simulated_figure(const flight::Flight& flown, const std::string& name) {
  return of_flight(flown, {}).at("flight." + name);
}

TEST(ReturnToTrim, OfASimulatedFlightGoesByItsTrueTilt) {
  const Finding found = simulated_figure(simulated(), "tilt_off_trim_deg");
  EXPECT_NEAR(std::get<Number>(*found.known).low, 23.98, 0.001);
  EXPECT_EQ(found.how, "at 11.99 s, the true tilt");
}

// Neither the true axis nor the avionics' can leave the guide's direction along a straight line.
TEST(ReturnToTrim, OfAMotionThatCannotTiltIsNotKnownUnlessNoCanardIsCommanded) {
  const Finding found = simulated_figure(simulated(false), "tilt_off_trim_deg");
  EXPECT_FALSE(found.known);
  EXPECT_EQ(found.how,
            "the simulated motion is straight and cannot tilt; allowed: flight.motion = \"six_dof\", or a trajectory "
            "that tilts");
  flight::Flight still = simulated(false);
  for (flight::Row& row : still.rows) {
    row.commands_rad = still.rows.front().commands_rad;
  }
  EXPECT_EQ(simulated_figure(still, "tilt_off_trim_deg").known, Known{exactly(0.0)});
}

TEST(ReturnToTrim, OfASimulatedFlightGoesByItsTrueCanardsWhateverTheirEncodersSay) {
  flight::Flight blind = simulated();
  for (flight::Row& row : blind.rows) {
    row.encoders_rad = {};
  }
  EXPECT_EQ(simulated_figure(blind, "left_trim_s").known, Known{exactly(9.0)});
  EXPECT_EQ(simulated_figure(blind, "canard_before_control_deg").known, Known{exactly(0.0)});
  EXPECT_EQ(simulated_figure(blind, "off_trim_after_abort").known, Known{false});
  for (flight::Row& row : blind.rows) {
    row.truth->shafts_rad->at(2) += row.time_s >= 5.0 ? text::radians(2.0) : 0.0;
  }
  EXPECT_EQ(simulated_figure(blind, "left_trim_s").known, Known{exactly(5.0)});
  EXPECT_NEAR(std::get<Number>(*simulated_figure(blind, "canard_before_control_deg").known).low, 2.0, 1e-6);
  EXPECT_EQ(simulated_figure(blind, "off_trim_after_abort").how,
            "abort at 12.00 s; shaft of canard 3 is away from trim at 12.50 s");
}

}  // namespace
}  // namespace fantail::rules::logged
