// SPDX-License-Identifier: MIT
// Every kind of flight that the simulator flies, through the reader and the replay that a person uses.

#include "flight_log/integrity.hpp"
#include "flight_log/regenerate.hpp"
#include "flight_log/to_report.hpp"
#include "input/fault_file.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "protocol/tick_digest.hpp"
#include "sim/world.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

struct Flown {
  std::vector<core::TickRecord> records;
  std::vector<std::byte> log;
};

Flown fly(const sim::Scenario& scenario) {
  sim::World world{scenario, sim::World::large_flash};
  Flown flown;
  while (!world.over()) {
    flown.records.push_back(world.tick());
    world.advance();
  }
  flown.log.assign(world.recorded().begin(), world.recorded().end());
  return flown;
}

bool was_flown(const Flown& flown) {
  return std::ranges::any_of(flown.records, [](const core::TickRecord& record) {
    return record.phase != core::Phase::safe && record.phase != core::Phase::armed;
  });
}

// Returns whether there was a flight to replay.
bool expect_equal_replay(const sim::Scenario& scenario) {
  const Flown flown = fly(scenario);
  if (!was_flown(flown) && flown.log.empty()) {
    return false;  // on the bench nothing pushes
  }
  const flight_log::LogFile file = flight_log::parse_log(flown.log, scenario.name);
  EXPECT_TRUE(flight_log::intact(file));
  EXPECT_FALSE(file.flights.empty());
  for (const flight_log::Flight& flight : file.flights) {
    const flight_log::Regeneration replay = flight_log::regenerate(flight, *flight.plan);
    EXPECT_TRUE(replay.complete_and_equal()) << flight_log::replay_text(flight, replay);
    // What is made again is what the flight law made then, every signal of it.
    auto then = flown.records.begin();
    for (const auto& record : replay.records) {
      then = std::find_if(then, flown.records.end(), [&](const auto& r) { return r.time == record->time; });
      if (then == flown.records.end() || protocol::tick_digest(*then) != protocol::tick_digest(*record)) {
        ADD_FAILURE() << "not as flown at " << record->time.count() << " us";
        return true;
      }
    }
  }
  return true;
}

TEST(ReplayedFlight, EveryShippedScenarioGivesTheSameBytesAgain) {
  std::size_t flights = 0;
  for (const std::string& name : input::shipped_names(input::Shipped::scenario)) {
    SCOPED_TRACE(name);
    flights += expect_equal_replay(input::load_scenario(name, {})) ? 1 : 0;
  }
  EXPECT_GE(flights, 9U) << "three launches, the steps in the tunnel, and six that left the pad in Safe";
}

TEST(ReplayedFlight, SoDoesAFlightWithEveryKindOfFaultInIt) {
  constexpr std::size_t one_imu_without_reset = 11;
  for (const input::FaultWords& words : input::fault_kinds().first(one_imu_without_reset)) {
    SCOPED_TRACE(words.kind);
    sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
    scenario.faults = {words.fault};
    scenario.faults[0].canard = 1;
    scenario.faults[0].from_s = 2.0;
    if (words.fault.until_s) {
      scenario.faults[0].until_s = 2.3;
    }
    EXPECT_TRUE(expect_equal_replay(scenario));
  }
}

TEST(ReplayedFlight, SoDoesAGyroThatFailsWhileTheLaunchIsBeingDetected) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch1", {});
  scenario.faults = {{.device = sim::Device::imu, .how = sim::Behaviour::hangs, .from_s = 0.05, .until_s = 0.12}};
  (void)expect_equal_replay(scenario);
}

TEST(ReplayedFlight, AsAReportItHasTheEventsOfTheFlight) {
  const Flown flown = fly(input::load_scenario("tasha3_launch2", {}));
  const flight_log::LogFile file = flight_log::parse_log(flown.log, "");
  const flight_log::Flight& flight = file.flights.at(0);
  const flight::Flight report = to_report(flight, regenerate(flight, *flight.plan));
  EXPECT_EQ(report.plan_name, "tasha3_launch2");
  const auto begin = [&](core::Phase phase) {
    const auto first = std::ranges::find(flown.records, phase, &core::TickRecord::phase);
    return 1e-6 * static_cast<double>((first->time - time_zero(flight, regenerate(flight, *flight.plan))).count());
  };
  EXPECT_NEAR(report.events.detected_s.value(), begin(core::Phase::launched), 1e-6);
  EXPECT_NEAR(report.events.control_start_s.value(), begin(core::Phase::controlling), 1e-6);
  EXPECT_NEAR(report.events.control_end_s.value(), begin(core::Phase::finished), 1e-6);
}

}  // namespace
}  // namespace fantail::sil
