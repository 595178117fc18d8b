// SPDX-License-Identifier: MIT
#include "flight_log/regenerate.hpp"

#include "core/flight_plan_fields.hpp"
#include "flight_log/log_maker.hpp"
#include "flight_log/made_flight.hpp"
#include "protocol/tick_digest.hpp"
#include "test.hpp"

namespace fantail::flight_log {
namespace {

using core::Microseconds;

Flight read(std::span<const std::byte> bytes) {
  LogFile file = parse_log(bytes, "");
  EXPECT_EQ(file.flights.size(), 1U);
  return file.flights.empty() ? Flight{} : std::move(file.flights[0]);
}

Flight made() {
  static const MadeFlight flight = make_flight();
  return read(flight.bytes);
}

void expect_same_records(const Regeneration& result, const std::vector<core::TickRecord>& records) {
  ASSERT_EQ(result.records.size(), records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    ASSERT_TRUE(result.records[i].has_value()) << i;
    ASSERT_EQ(protocol::tick_digest(*result.records[i]), protocol::tick_digest(records[i])) << i;
  }
}

// The first tick of the flight in which it controls.
std::size_t first_controlling(const Flight& flight) {
  std::size_t i = 0;
  while (flight.ticks[i].tick.phase != core::Phase::controlling) {
    ++i;
  }
  return i;
}

TEST(Regenerate, AFlightReplayedFromItsFirstCheckpointGivesEverySignalAgain) {
  const MadeFlight flown = make_flight();
  const Flight flight = read(flown.bytes);
  const Regeneration result = regenerate(flight, *flight.plan);
  EXPECT_EQ(result.compared, flown.records.size());
  EXPECT_EQ(result.differing, 0U);
  EXPECT_EQ(result.unreachable, 0U);
  EXPECT_TRUE(result.complete_and_equal());
  EXPECT_EQ(result.obstacle, "");
  expect_same_records(result, flown.records);
}

TEST(Regenerate, EveryCheckpointLeadsToTheSameFlight) {
  const Flight whole = made();
  ASSERT_GT(whole.checkpoints.size(), 4U);
  for (std::size_t first = 1; first < whole.checkpoints.size(); ++first) {
    Flight flight = whole;
    flight.checkpoints.erase(flight.checkpoints.begin(),
                             flight.checkpoints.begin() + static_cast<std::ptrdiff_t>(first));
    const Regeneration result = regenerate(flight, *flight.plan);
    EXPECT_EQ(result.unreachable, 500U * first) << "a checkpoint every half second";
    EXPECT_EQ(result.compared, whole.ticks.size() - 500U * first);
    EXPECT_EQ(result.differing, 0U) << "from checkpoint " << first;
  }
}

TEST(Regenerate, AfterAGapItGoesOnFromTheNextCheckpoint) {
  const MadeFlight flown = make_flight();
  std::vector<std::byte> bytes = flown.bytes;
  // Two ticks in the first half second and so far from the next checkpoint.
  bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(flown.frame_ends[99]),
              bytes.begin() + static_cast<std::ptrdiff_t>(flown.frame_ends[101]));
  const Flight flight = read(bytes);
  const Regeneration result = regenerate(flight, *flight.plan);
  EXPECT_EQ(flight.ticks.size(), 2998U);
  EXPECT_EQ(result.differing, 0U);
  EXPECT_EQ(result.compared + result.unreachable, 2998U);
  EXPECT_FALSE(result.complete_and_equal());
  EXPECT_TRUE(result.records[90].has_value());
  EXPECT_FALSE(result.records[110].has_value());
  EXPECT_FALSE(result.records[497].has_value());
  EXPECT_TRUE(result.records[498].has_value()) << "the 500th tick follows the second checkpoint";
}

TEST(Regenerate, ATickThatCannotBeReadIsAGapToo) {
  Flight flight = made();
  flight.unknown_ticks.push_back(flight.ticks[100].sequence);
  flight.ticks.erase(flight.ticks.begin() + 100);
  const Regeneration result = regenerate(flight, *flight.plan);
  EXPECT_FALSE(result.records[100].has_value());
  EXPECT_TRUE(result.records[499].has_value());
  EXPECT_EQ(result.differing, 0U);
}

TEST(Regenerate, TheFirstDifferenceIsNamedWithBothValues) {
  const Flight flight = made();
  const std::size_t at = first_controlling(flight) + 10;
  struct Case {
    std::string field;
    std::string recorded;
    std::function<void(protocol::LogTick&)> change;
  };
  const std::vector<Case> cases{
      {"phase", "finished", [](auto& tick) { tick.phase = core::Phase::finished; }},
      {"command_status", "gyro_lost", [](auto& tick) { tick.command_status = core::CommandStatus::gyro_lost; }},
      {"saturated", "", [](auto& tick) { tick.saturated = !tick.saturated; }},
      {"timing_fault", "1", [](auto& tick) { tick.timing_fault = true; }},
      {"command", "0.25 rad", [](auto& tick) { tick.command = core::Angle::from_radians(0.25F); }},
      {"command_3", "1.234 deg", [](auto& tick) { tick.canard_commands[2] = core::Angle::from_degrees(1.234F); }},
      {"command_4", "not driven", [](auto& tick) { tick.canard_commands[3].reset(); }},
      {"digest", "00c0ffee", [](auto& tick) { tick.digest = 0x00C0FFEE; }},
  };
  for (const Case& wrong : cases) {
    Flight changed = flight;
    wrong.change(changed.ticks[at].tick);
    const Regeneration result = regenerate(changed, *changed.plan);
    EXPECT_EQ(result.differing, 1U) << wrong.field;
    ASSERT_TRUE(result.first_difference.has_value()) << wrong.field;
    EXPECT_EQ(result.first_difference->tick, at);
    EXPECT_EQ(result.first_difference->field, wrong.field);
    EXPECT_NE(result.first_difference->recorded, result.first_difference->replayed);
    if (!wrong.recorded.empty()) {
      EXPECT_EQ(result.first_difference->recorded, wrong.recorded);
    }
  }
}

TEST(Regenerate, ACommandOfMinusZeroIsNotOneOfZero) {
  Flight flight = made();
  flight.ticks[3].tick.command = core::Angle::from_radians(-0.0F);
  const Regeneration result = regenerate(flight, *flight.plan);
  ASSERT_TRUE(result.first_difference.has_value());
  EXPECT_EQ(result.first_difference->field, "command");
  EXPECT_EQ(result.first_difference->recorded, "-0 rad");
}

TEST(Regenerate, AnInputThatWasTamperedWithShows) {
  Flight flight = made();
  flight.ticks[700].tick.rate_counts[0] = static_cast<std::int16_t>(flight.ticks[700].tick.rate_counts[0] + 1);
  const Regeneration result = regenerate(flight, *flight.plan);
  ASSERT_TRUE(result.first_difference.has_value());
  EXPECT_EQ(result.first_difference->tick, 700U);
}

TEST(Regenerate, AnotherPlanShowsWhatTheCommandsWouldHaveBeen) {
  const Flight flight = made();
  core::FlightPlan plan = *flight.plan;
  plan.controller.canard_limit = core::Angle::from_degrees(2.0F);
  const Regeneration result = regenerate(flight, plan);
  EXPECT_GT(result.differing, 0U);
  const std::size_t start = first_controlling(flight);
  ASSERT_TRUE(result.first_difference.has_value());
  EXPECT_GE(result.first_difference->tick, start) << "on the pad nothing changes";
  for (const auto& record : result.records) {
    EXPECT_LE(std::abs(record->command.degrees()), 2.0001F);
  }
}

TEST(Regenerate, WhatMakesAReplayImpossibleIsSaid) {
  const Flight flight = made();
  const auto obstacle = [&](const std::function<void(Flight&)>& change) {
    Flight changed = flight;
    change(changed);
    const Regeneration result = regenerate(changed, core::default_plan());
    EXPECT_EQ(result.compared, 0U);
    EXPECT_EQ(result.unreachable, changed.ticks.size());
    EXPECT_EQ(result.records.size(), changed.ticks.size());
    return result.obstacle;
  };
  const auto says = [](const std::string& text, const char* word) { return text.find(word) != std::string::npos; };
  EXPECT_TRUE(says(obstacle([](Flight& f) { f.has_header = false; }), "header"));
  EXPECT_TRUE(says(obstacle([](Flight& f) { f.state_layout += 1; }), "another version of the flight law"));
  EXPECT_TRUE(says(obstacle([](Flight& f) { f.checkpoints.clear(); }), "no checkpoint"));
  EXPECT_TRUE(says(obstacle([](Flight& f) { f.ticks.clear(); }), "no tick"));
  EXPECT_TRUE(says(obstacle([](Flight& f) {
                     f.ticks.clear();
                     f.foreign_ticks.resize(1);
                   }),
                   "another version"));
  EXPECT_TRUE(says(obstacle([](Flight& f) {
                     for (Checkpoint& checkpoint : f.checkpoints) {
                       checkpoint.state.pop_back();
                     }
                   }),
                   "checkpoints"));
}

TEST(Regenerate, ACheckpointThatCannotBeIsPassedOver) {
  Flight flight = made();
  std::ranges::fill(flight.checkpoints[0].state, std::byte{0xFF});
  const Regeneration result = regenerate(flight, *flight.plan);
  EXPECT_EQ(result.unreachable, 500U);
  EXPECT_EQ(result.differing, 0U);
}

}  // namespace
}  // namespace fantail::flight_log
