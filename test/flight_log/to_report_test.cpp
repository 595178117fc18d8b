// SPDX-License-Identifier: MIT
#include "flight_log/to_report.hpp"

#include <gtest/gtest.h>

#include "flight/write_csv.hpp"
#include "flight_log/made_flight.hpp"

namespace fantail::flight_log {
namespace {

using core::Microseconds;

struct Read {
  MadeFlight made = make_flight();
  Flight flight = parse_log(made.bytes, "").flights.at(0);
  Regeneration regeneration = regenerate(flight, *flight.plan);
};

// Flown from 5.5 s on, thrust from 6 s on: the tick at 6.000 s has the first sample with thrust, which the replayed
// window includes.
constexpr double pad_s = 0.5;

TEST(ToReport, HasARowForEveryTickWithTimeZeroAtTheStartOfTheReplayedWindow) {
  const Read read;
  const flight::Flight flight = to_report(read.flight, read.regeneration);
  ASSERT_EQ(flight.rows.size(), 3000U);
  EXPECT_NEAR(flight.rows.front().time_s, -pad_s, 0.005);
  EXPECT_NEAR(flight.rows[1].time_s - flight.rows[0].time_s, 0.001, 1e-9);
  EXPECT_EQ(flight.events.liftoff_s, 0.0);
  EXPECT_FALSE(flight.tunnel);
  for (std::size_t i = 0; i < flight.rows.size(); ++i) {
    ASSERT_EQ(flight.rows[i].roll_angle_rad, static_cast<double>(read.made.records[i].motion.roll_angle.radians()));
    ASSERT_FALSE(flight.rows[i].truth.has_value());
  }
}

// As log info calls it, and not after its place in the flash.
TEST(ToReport, IsCalledByItsNumberInTheFile) {
  MadeFlight two = make_flight();
  const MadeFlight second = make_flight({.flight = 0x40000});
  two.bytes.insert(two.bytes.end(), second.bytes.begin(), second.bytes.end());
  const LogFile file = parse_log(two.bytes, "");
  ASSERT_EQ(file.flights.size(), 2U);
  const Flight& flight = file.flights[1];
  EXPECT_EQ(flight.flight, 0x40000U);
  EXPECT_TRUE(to_report(flight, regenerate(flight, *flight.plan)).scenario.starts_with("flight 2, power-up"));
}

TEST(ToReport, KnowsWhoFlewWhat) {
  const Read read;
  const flight::Flight flight = to_report(read.flight, read.regeneration);
  EXPECT_EQ(flight.vehicle, "paper dart");
  EXPECT_EQ(flight.version, "0.1.0");
  EXPECT_NE(flight.plan_name.find("plan "), std::string::npos) << "the default plan is not one of the shipped ones";
  EXPECT_TRUE(flight.notes.empty());
}

TEST(ToReport, HasThePhasesWithTheirReasonsAndTheEvents) {
  const Read read;
  const flight::Flight flight = to_report(read.flight, read.regeneration);
  ASSERT_GE(flight.phase_changes.size(), 3U);
  EXPECT_EQ(flight.phase_changes[0].phase, core::Phase::armed);
  EXPECT_EQ(flight.phase_changes[1].reason, core::PhaseReason::launch_detected);
  EXPECT_EQ(flight.phase_changes[2].reason, core::PhaseReason::guide_clear);
  EXPECT_EQ(flight.events.detected_s, flight.phase_changes[1].time_s);
  EXPECT_EQ(flight.events.control_start_s, flight.phase_changes[2].time_s);
  EXPECT_FALSE(flight.events.control_end_s.has_value());
}

TEST(ToReport, AfterAGapTheBeginOfAPhaseIsWhatTheRecorderNotedOrUnknown) {
  const Read read;
  Flight flight = read.flight;
  // Nothing is left of the half second in which it was detected and control began.
  flight.checkpoints.erase(flight.checkpoints.begin(), flight.checkpoints.begin() + 3);
  const Regeneration regeneration = regenerate(flight, *flight.plan);
  const auto begins = to_report(read.flight, read.regeneration).events;
  const auto noted = to_report(flight, regeneration);
  const double moved_s = *begins.liftoff_s - *noted.events.liftoff_s;
  EXPECT_NEAR(*noted.events.control_start_s + moved_s, *begins.control_start_s, 1e-6);
  EXPECT_FALSE(noted.notes.empty());

  flight.events.clear();
  EXPECT_FALSE(to_report(flight, regeneration).events.control_start_s.has_value());
}

TEST(ToReport, AFlightThatCannotBeReplayedHasNoRowsAndSaysWhy) {
  const Read read;
  Flight flight = read.flight;
  flight.checkpoints.clear();
  const flight::Flight result = to_report(flight, regenerate(flight, *flight.plan));
  EXPECT_TRUE(result.rows.empty());
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_NE(result.notes[0].find("no checkpoint"), std::string::npos);
}

}  // namespace
}  // namespace fantail::flight_log
