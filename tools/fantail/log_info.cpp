// SPDX-License-Identifier: MIT
#include "fantail/log_info.hpp"

#include <memory>
#include <utility>

#include <fmt/core.h>

#include "fantail/deliver.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/terminal.hpp"
#include "flight_log/integrity.hpp"
#include "flight_log/to_report.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

struct InfoOptions {
  std::string log;
  std::optional<std::size_t> flight;
  bool json = false;
};

std::string heading(const flight_log::LogFile& file) {
  std::string text =
      fmt::format("{}: {} bytes, {}\n", file.name, file.bytes,
                  file.flights.size() == 1 ? "one flight" : fmt::format("{} flights", file.flights.size()));
  if (const std::string foreign = flight_log::foreign_bytes_text(file); !foreign.empty()) {
    text += foreign + "\n";
  }
  if (file.records_left_out > 0) {
    text += fmt::format("{} after flight {} left out: no more flights are read\n",
                        text::counted(file.records_left_out, "record"), file.flights.size());
  }
  return text;
}

void show_info(const InfoOptions& options) {
  Chapters chapters{"log info", 2, "reading " + options.log};
  flight_log::LogFile file = flight_log::read_log_file(options.log);
  if (options.flight) {
    // The bytes between the flights are nothing to do with one of them.
    flight_log::Flight chosen = take_flight(file, options.flight);
    file.flights.clear();
    file.flights.push_back(std::move(chosen));
  }
  chapters.next("replaying the recording");
  std::vector<FlightInfo> flights;
  for (std::size_t i = 0; i < file.flights.size(); ++i) {
    give_up_if_interrupted();
    flights.push_back(flight_info(file.flights[i]));
  }
  chapters.end();
  if (options.json) {
    fmt::print("{}", log_info_json(file, flights, made_with({options.log})));
  } else {
    show("{}", heading(file));
    for (const FlightInfo& info : flights) {
      show("{}", log_info_text(info));
    }
  }
  if (!flight_log::intact(file)) {
    throw RequirementNotMet{""};
  }
}

}  // namespace

FlightInfo flight_info(const flight_log::Flight& flight) {
  flight_log::Regeneration replay;
  if (flight.plan) {
    replay = flight_log::regenerate(flight, *flight.plan);
  } else {
    replay.unreachable = flight.ticks.size();
    replay.obstacle = flight.has_header ? "Its flight plan cannot be used: " + flight.plan_fault + "."
                                        : "It has no intact header, so there is no flight plan.";
  }
  const core::Microseconds zero = flight_log::time_zero(flight, replay);
  const std::string_view zero_text = flight_log::time_zero_text(flight, replay);
  return {.flight = flight,
          .replay = std::move(replay),
          .loop = flight_log::loop_times(flight),
          .health = flight_log::health_figures(flight),
          .zero = zero,
          .zero_text = zero_text,
          .plan = flight_log::plan_name(flight)};
}

void add_log_info(const Verb& log) {
  auto verb = log.verb("info", "Content of a flight log, whether it is intact, and whether a replay agrees");
  auto options = std::make_shared<InfoOptions>();
  verb.option("LOG", options->log, "A flight log (.ftl), or a folder with a flight.ftl").offers(files).required();
  add_flight_choice(verb, options->flight, " [all]");
  verb.flag("--json", options->json, "Print one JSON object");
  verb.examples(
      "Times count from lift-off, in the tunnel from the start of control; if the record shows neither, from its "
      "beginning.\n"
      "Exit code 0: intact, also when the recording ends early; 1: records are missing or bytes damaged.\n"
      "Examples:\n"
      "  fantail log info out/tasha3_launch2    vehicle and plan, is it intact, does a replay agree\n"
      "  fantail log info flash.ftl --flight 2  one of several flights from a board's flash\n"
      "  fantail log info flown.ftl --json      every figure and every event, for a script");
  verb.action([options] { show_info(*options); });
}

}  // namespace fantail::tool
