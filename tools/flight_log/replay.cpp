// SPDX-License-Identifier: MIT
#include "flight_log/replay.hpp"

#include <fmt/core.h>

#include "input/plan_file.hpp"
#include "text/error.hpp"

namespace fantail::flight_log {
namespace {

[[noreturn]] void refuse(const std::string& log, const std::string& why) {
  throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: cannot be replayed. {}", log, why)};
}

}  // namespace

core::FlightPlan plan_for_replay(const Flight& flight, const std::string& log,
                                 std::span<const input::Override> changes) {
  if (!flight.plan) {
    refuse(log, flight.has_header ? "Its flight plan cannot be used: " + flight.plan_fault + "."
                                  : "No intact header is left, and so no flight plan.");
  }
  for (const input::Override& change : changes) {
    if (change.section == "sensors" && !change.key.starts_with("gyro")) {
      refuse(log,
             fmt::format("{} changes nothing in a replay: what a log holds is turned into the rocket's axes already",
                         change.text()));
    }
  }
  return changes.empty() ? *flight.plan : input::changed_plan(*flight.plan, changes);
}

Regeneration replay(const Flight& flight, const std::string& log, const core::FlightPlan& plan) {
  Regeneration result = regenerate(flight, plan);
  if (!result.obstacle.empty()) {
    refuse(log, result.obstacle);
  }
  return result;
}

}  // namespace fantail::flight_log
