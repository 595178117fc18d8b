// SPDX-License-Identifier: MIT
#include "benchmark/logged_flight.hpp"

#include <array>
#include <stdexcept>

#include "fly/fly_scenario.hpp"
#include "input/document.hpp"
#include "input/plan_file.hpp"
#include "input/scenario_file.hpp"

namespace fantail::benchmark {
namespace {

LoggedFlight fly() {
  const std::array changes{input::parse_override("run.control_time_s=30")};
  LoggedFlight logged;
  logged.bytes = fly::fly_scenario(input::load_scenario("tunnel_steps", changes), {}, {}, fly::Log::kept).log;
  flight_log::LogFile file = flight_log::parse_log(logged.bytes, "benchmark");
  if (file.flights.size() != 1 || !file.flights[0].plan) {
    throw std::runtime_error{"the flight was not recorded"};
  }
  logged.flight = std::move(file.flights[0]);
  logged.regeneration = flight_log::regenerate(logged.flight, *logged.flight.plan);
  if (logged.regeneration.differing > 0 || logged.regeneration.unreachable > 0) {
    throw std::runtime_error{"the replay differs from the flight"};
  }
  return logged;
}

}  // namespace

const LoggedFlight& logged_flight() {
  static const LoggedFlight logged = fly();
  return logged;
}

}  // namespace fantail::benchmark
