// SPDX-License-Identifier: MIT
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "core/autopilot.hpp"
#include "flight_log/event_text.hpp"
#include "flight_log/integrity.hpp"
#include "flight_log/regenerate.hpp"
#include "flight_log/to_report.hpp"
#include "input/scenario_file.hpp"
#include "json/value.hpp"
#include "logs/flight_file.hpp"
#include "protocol/state_block.hpp"
#include "python/bindings/bind.hpp"
#include "python/bindings/flown.hpp"
#include "python/bindings/scenario.hpp"
#include "text/error.hpp"

namespace nb = nanobind;

namespace fantail::python {
namespace {

using flight_log::Flight;
using flight_log::LogFile;

double seconds(core::Microseconds time) { return static_cast<double>(time.count()) / 1e6; }

Flight& flight_of(LogFile& file, std::size_t index) {
  if (index >= file.flights.size()) {
    throw nb::index_error("flight");
  }
  return file.flights[index];
}

nb::list recorded_events(const Flight& flight) {
  nb::list all;
  for (const protocol::LogEvent& event : flight.events) {
    all.append(nb::make_tuple(seconds(event.time), flight_log::event_text(event, flight.first_time)));
  }
  return all;
}

std::string result_json(const Flight& flight, const flight_log::Regeneration& r) {
  json::Value all{{"equal", r.differing == 0},    {"ticks", flight.ticks.size()}, {"compared", r.compared},
                  {"unreachable", r.unreachable}, {"differing", r.differing},     {"first_difference", nullptr}};
  if (const auto& difference = r.first_difference) {
    all["first_difference"] = {{"tick", difference->tick},
                               {"power_up_time_s", seconds(flight.ticks[difference->tick].tick.time)},
                               {"field", difference->field},
                               {"recorded", difference->recorded},
                               {"replayed", difference->replayed}};
  }
  return all.dump();
}

std::pair<std::string, Flown> replay(const Flight& flight, const std::string& log,
                                     const std::vector<std::string>& changes) {
  const core::FlightPlan plan = flight_log::plan_for_replay(flight, log, input::parse_overrides(changes));
  const flight_log::Regeneration result = flight_log::replay(flight, log, plan);
  flight::Flight flown = flight_log::to_report(flight, result);
  flown.plan = plan;
  flown.changes = changes;
  return {result_json(flight, result), Flown{std::move(flown)}};
}

std::vector<core::Inputs> inputs(const Flight& flight) {
  std::vector<core::Inputs> all;
  if (flight.plan) {
    for (const flight_log::LoggedTick& logged : flight.ticks) {
      all.push_back(flight_log::inputs_of(flight, logged.tick, flight.plan->canards));
    }
  }
  return all;
}

std::vector<float> commands_rad(const Flight& flight) {
  std::vector<float> all;
  all.reserve(flight.ticks.size());
  for (const flight_log::LoggedTick& logged : flight.ticks) {
    all.push_back(logged.tick.command.radians());
  }
  return all;
}

/// The law as it was before the first tick that follows its first memory, and the index of that tick.
std::pair<core::Autopilot, std::size_t> autopilot(const Flight& flight, const std::string& log) {
  const core::FlightPlan plan = flight_log::plan_for_replay(flight, log, {});
  core::Autopilot law{plan};
  if (flight.checkpoints.empty() || !protocol::restore_state(law, flight.checkpoints.front().state)) {
    throw text::Error{text::ErrorKind::bad_data,
                      log + ": cannot be replayed. It holds no checkpoint that fits this program's flight law."};
  }
  std::size_t first = 0;
  while (first < flight.ticks.size() && flight.ticks[first].sequence < flight.checkpoints.front().sequence) {
    ++first;
  }
  return {law, first};
}

}  // namespace

void bind_logs(nb::module_& m) {
  auto bound_log = nb::class_<LogFile>(m, "Log")
                       .def_static(
                           "read", [](const std::string& path) { return flight_log::read_log_file(path); },
                           nb::arg("path"), nb::call_guard<nb::gil_scoped_release>())
                       .def_ro("name", &LogFile::name)
                       .def_ro("bytes", &LogFile::bytes)
                       .def_ro("foreign_bytes", &LogFile::foreign_bytes)
                       .def_prop_ro("intact", [](const LogFile& file) { return flight_log::intact(file); })
                       .def("__len__", [](const LogFile& file) { return file.flights.size(); })
                       .def("flight", &flight_of, nb::arg("index"), nb::rv_policy::reference_internal);
  refuse_to_pickle(bound_log, "Log", "pass its path, and call read_log() there");
  auto bound_logged =
      nb::class_<Flight>(m, "LoggedFlight")
          .def_ro("number", &Flight::number)
          .def_ro("vehicle", &Flight::vehicle)
          .def_ro("sensors", &Flight::sensors)
          .def_ro("firmware_version", &Flight::firmware_version)
          .def_ro("git_hash", &Flight::git_hash)
          .def_ro("plan", &Flight::plan)
          .def_prop_ro("ticks", [](const Flight& f) { return f.ticks.size(); })
          .def_prop_ro("from_s", [](const Flight& f) { return seconds(f.first_time); })
          .def_prop_ro("to_s", [](const Flight& f) { return seconds(f.last_time); })
          .def_prop_ro("intact", [](const Flight& f) { return flight_log::intact(f); })
          .def_prop_ro("integrity", [](const Flight& f) { return flight_log::integrity_text(f); })
          .def_prop_ro("events", &recorded_events)
          .def("inputs", &inputs)
          .def("commands_rad", [](const Flight& f) { return column_of<float>(commands_rad(f)); })
          .def("autopilot", &autopilot, nb::arg("log"))
          .def("replay", &replay, nb::arg("log"), nb::arg("changes"), nb::call_guard<nb::gil_scoped_release>());
  refuse_to_pickle(bound_logged, "LoggedFlight",
                   "pass the path of its log and its place in it, and call read_log(path)[place] there");
  m.def(
      "read_flight", [](const std::string& path) { return Flown{logs::read_flight(path)}; }, nb::arg("path"),
      nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace fantail::python
