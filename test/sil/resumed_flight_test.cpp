// SPDX-License-Identifier: MIT
// The processor is reset in flight and the world goes on: what is flown, recorded, replayed and said of it.

#include "degree.hpp"
#include "figures.hpp"
#include "flight_log/integrity.hpp"
#include "flight_log/regenerate.hpp"
#include "flight_log/to_report.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "report/results.hpp"
#include "sim/world.hpp"
#include "test.hpp"
#include "text/number.hpp"

namespace fantail::sil {
namespace {

sim::Scenario with_resets(const std::vector<double>& times_s, const sim::Reset& reset = {}) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  for (const double time_s : times_s) {
    scenario.faults.push_back({.device = sim::Device::processor, .how = reset, .from_s = time_s});
  }
  return scenario;
}

double angle_error_rad(const flight::Row& row) { return row.roll_angle_rad - row.truth->roll_angle_rad; }

/// The last row before the first outage and the first after it.
std::pair<flight::Row, flight::Row> around_outage(const flight::Flight& flight) {
  const auto after = std::ranges::find_if(
      flight.rows, [&](const auto& row) { return row.time_s > flight.outages.at(0).from_s + 1e-6; });
  return {*(after - 1), *after};
}

// The roll rate is taken to go evenly over the gap, from the last seal on: 10 ms more at most. With an acceleration of
// at most A that is wrong by A gap^2 / 4 at most.
TEST(ResumedFlight, AResetByTheWatchdogIsFlownThroughAndControlGoesOnInTheNextTick) {
  for (const double gap_s : {0.02, 0.06, 0.1, 0.2}) {
    const flight::Flight flight = fly::fly_scenario(with_resets({3.0}, {.gap_s = gap_s}));
    ASSERT_EQ(flight.outages.size(), 1U);
    EXPECT_TRUE(flight.outages[0].resumed);
    EXPECT_NEAR(*flight.outages[0].to_s - flight.outages[0].from_s, gap_s + 0.001, 1e-6);
    const auto [before, after] = around_outage(flight);
    EXPECT_EQ(after.phase, core::Phase::controlling);
    EXPECT_EQ(after.time_s, flight.outages[0].to_s);
    constexpr double largest_acceleration_rad_s2 = 500.0 * degree;
    const double bound_rad = largest_acceleration_rad_s2 * (gap_s + 0.011) * (gap_s + 0.011) / 4.0;
    EXPECT_LE(std::abs(angle_error_rad(after) - angle_error_rad(before)), bound_rad + 0.05 * degree) << gap_s;
    const std::string said = report::results(flight).verdict.text;
    EXPECT_EQ(flight.outages[0].cause, "watchdog");
    EXPECT_TRUE(says(said, "watchdog"));
    EXPECT_TRUE(tells(said, {text::fixed(flight.outages[0].from_s, 3), text::fixed(*flight.outages[0].to_s, 3)}));
  }
}

TEST(ResumedFlight, AGapThatIsTakenForLongerTurnsIntoRollRateTimesTheError) {
  constexpr double clock_error_s = 0.04;
  sim::Scenario scenario = with_resets({3.0}, {.gap_s = 0.05});
  const auto [unused, right] = around_outage(fly::fly_scenario(scenario));
  std::get<sim::Reset>(scenario.faults[0].how).clock_error_s = clock_error_s;
  const auto [before, wrong] = around_outage(fly::fly_scenario(scenario));
  // From the seal on, which is up to 10 ms old, the rate goes evenly to the new one.
  const double mean_rate_rad_s = 0.5 * (before.roll_rate_rad_s + wrong.roll_rate_rad_s);
  EXPECT_GT(std::abs(mean_rate_rad_s), 4.0 * degree);
  EXPECT_NEAR(wrong.roll_angle_rad - right.roll_angle_rad, mean_rate_rad_s * clock_error_s, 0.1 * degree);
  EXPECT_EQ(wrong.truth->roll_angle_rad, right.truth->roll_angle_rad);
}

TEST(ResumedFlight, AfterAnyOtherResetOrWithoutItsMemoryControlIsOver) {
  using hal::ResetCause;
  for (const sim::Reset reset : {sim::Reset{.cause = ResetCause::power_on}, sim::Reset{.cause = ResetCause::brown_out},
                                 sim::Reset{.cause = ResetCause::pin}, sim::Reset{.gap_s = 0.3},
                                 sim::Reset{.memory = sim::MemoryAfterReset::lost}}) {
    const flight::Flight flight = fly::fly_scenario(with_resets({3.0}, reset));
    ASSERT_EQ(flight.outages.size(), 1U);
    EXPECT_FALSE(flight.outages[0].resumed);
    EXPECT_EQ(flight.rows.back().phase, core::Phase::safe);
    EXPECT_EQ(flight.events.control_end_s, flight.outages[0].from_s);
    const report::Verdict verdict = report::results(flight).verdict;
    EXPECT_NE(verdict.outcome, report::Outcome::held);
    EXPECT_TRUE(verdict.ended_early);
    EXPECT_TRUE(says(verdict.text, "reset") && says(verdict.text, flight.outages[0].cause)) << verdict.text;
    EXPECT_TRUE(tells(verdict.text, {text::fixed(flight.outages[0].from_s, 2)})) << verdict.text;
  }
}

TEST(ResumedFlight, BeforeControlBeginsAResetThatIsNotResumedIsTheReasonForNoControl) {
  const flight::Flight flight = fly::fly_scenario(with_resets({0.3}, {.cause = hal::ResetCause::brown_out}));
  const report::Verdict verdict = report::results(flight).verdict;
  EXPECT_EQ(verdict.outcome, report::Outcome::no_control);
  EXPECT_TRUE(says(verdict.text, "reset") && tells(verdict.text, {text::fixed(flight.phase_changes.back().time_s, 2)}))
      << verdict.text;
}

TEST(ResumedFlight, ABootLoopEndsInSafeAfterThreeResumes) {
  std::vector<double> times_s;
  for (int i = 0; i < 12; ++i) {
    times_s.push_back(3.0 + 0.07 * i);  // ten ticks between two of them
  }
  const flight::Flight flight = fly::fly_scenario(with_resets(times_s));
  ASSERT_EQ(flight.outages.size(), times_s.size());
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    EXPECT_EQ(flight.outages[i].resumed, i < 3) << i;
  }
  EXPECT_EQ(flight.rows.back().phase, core::Phase::safe);
}

TEST(ResumedFlight, UntilTheWatchdogResetsThePulsesStayAndThenThereAreNoneUntilTheNextTick) {
  const sim::Scenario scenario = with_resets({3.0}, {.gap_s = 0.05});
  sim::World world{scenario};
  std::size_t with_pulses = 0;
  std::size_t without = 0;
  std::array<std::optional<hal::Pulse>, hal::canards> before{};
  while (!world.over()) {
    const core::TickRecord& record = world.tick();
    if (!world.is_down()) {
      before = world.hardware().pulses;
      EXPECT_EQ(record.time, world.now());
    } else if (world.hardware().pulses[0]) {
      EXPECT_EQ(world.hardware().pulses, before);
      with_pulses += 1;
    } else {
      without += 1;
    }
    world.advance();
  }
  EXPECT_EQ(with_pulses, 40U);
  EXPECT_EQ(without, 10U);
}

TEST(ResumedFlight, UntilTheResetItIsTheSameFlightAsWithoutOne) {
  const flight::Flight whole = fly::fly_scenario(with_resets({}));
  const flight::Flight reset = fly::fly_scenario(with_resets({3.0}));
  std::size_t same = 0;
  while (reset.rows[same].time_s <= reset.outages[0].from_s) {
    ASSERT_EQ(reset.rows[same].command_rad, whole.rows[same].command_rad) << same;
    ASSERT_EQ(reset.rows[same].truth->roll_angle_rad, whole.rows[same].truth->roll_angle_rad) << same;
    same += 1;
  }
  EXPECT_GT(same, 3000U);
}

TEST(ResumedFlight, EveryPartOfItsLogReplaysExactlyAndOneReportIsMadeOfThem) {
  const flight::Flight flown =
      fly::fly_scenario(with_resets({3.0, 4.5}, {.cause = hal::ResetCause::software}), {}, {}, fly::Log::kept);
  const flight_log::LogFile file = flight_log::parse_log(flown.log, "");
  ASSERT_EQ(file.flights.size(), 3U);
  EXPECT_TRUE(flight_log::is_one_flight(file));
  EXPECT_TRUE(flight_log::intact(file)) << "a record that a reset cut off is no damage";
  const std::string of_the_first = flight_log::integrity_text(file.flights[0]);
  EXPECT_TRUE(says(of_the_first, "reset") && tells(of_the_first, {"2"})) << "it goes on in flight 2; " << of_the_first;
  std::vector<flight_log::Regeneration> replays;
  for (const flight_log::Flight& part : file.flights) {
    replays.push_back(flight_log::regenerate(part, *part.plan));
    EXPECT_TRUE(replays.back().complete_and_equal()) << flight_log::replay_text(part, replays.back());
  }
  const flight::Flight report = flight_log::to_report(std::vector<flight_log::Part>{
      {file.flights[0], replays[0]}, {file.flights[1], replays[1]}, {file.flights[2], replays[2]}});
  ASSERT_EQ(report.outages.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(report.outages[i].cause, "software");
    EXPECT_TRUE(report.outages[i].resumed);
    // What waited for the flash is lost, and the rest begins when the flash is ready.
    EXPECT_LE(report.outages[i].from_s, flown.outages[i].from_s + 0.001);
    EXPECT_GE(*report.outages[i].to_s, *flown.outages[i].to_s - 0.001);
    EXPECT_LE(*report.outages[i].to_s - *flown.outages[i].to_s, 0.1);
  }
  EXPECT_NEAR(*report.events.control_start_s, *flown.events.control_start_s, 0.01);
  EXPECT_NEAR(*report.events.control_end_s, *flown.events.control_end_s, 0.01);
  EXPECT_TRUE(std::ranges::is_sorted(report.rows, {}, &flight::Row::time_s));
}

TEST(ResumedFlight, TwoFlightsOfABoardAreNotTakenForOne) {
  const flight::Flight flown = fly::fly_scenario(with_resets({3.0}), {}, {}, fly::Log::kept);
  std::vector<std::byte> twice = flown.log;
  twice.insert(twice.end(), flown.log.begin(), flown.log.end());
  const flight_log::LogFile file = flight_log::parse_log(twice, "");
  ASSERT_EQ(file.flights.size(), 4U);
  EXPECT_FALSE(flight_log::is_one_flight(file));
  EXPECT_TRUE(file.flights[2].goes_on);
}

}  // namespace
}  // namespace fantail::sil
