// SPDX-License-Identifier: MIT
#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "fantail/deliver.hpp"
#include "fantail/log_info.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/terminal.hpp"
#include "fantail/what_if.hpp"
#include "flight_log/integrity.hpp"
#include "flight_log/regenerate.hpp"
#include "input/scenario_file.hpp"
#include "json/value.hpp"
#include "text/degrees.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

struct ReplayOptions {
  std::string log;
  std::vector<std::string> changes;
  std::optional<std::size_t> flight;
  std::string out;
  bool json = false;
};

struct Replayed {
  flight_log::Regeneration result;
  double ticks_per_s = 0.0;
};

Replayed timed_replay(const flight_log::Flight& flight, const std::string& log, const core::FlightPlan& plan) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  flight_log::Regeneration result = flight_log::replay(flight, log, plan);
  const std::chrono::duration<double> took = Clock::now() - begin;
  const double rate = took.count() > 0.0 ? static_cast<double>(result.compared) / took.count() : 0.0;
  return {.result = std::move(result), .ticks_per_s = rate};
}

json::Value to_json(const ReplayOptions& options, const flight_log::Flight& flight, const Replayed& replayed) {
  const flight_log::Regeneration& r = replayed.result;
  json::Value json{{"log", options.log},
                   {"equal", r.differing == 0},
                   {"ticks", flight.ticks.size()},
                   {"compared", r.compared},
                   {"unreachable", r.unreachable},
                   {"differing", r.differing},
                   {"ticks_per_s", replayed.ticks_per_s},
                   {"first_difference", nullptr}};
  if (const auto& difference = r.first_difference) {
    json["first_difference"] = {
        {"tick", difference->tick},
        {"power_up_time_s", static_cast<double>(flight.ticks[difference->tick].tick.time.count()) / 1e6},
        {"field", difference->field},
        {"recorded", difference->recorded},
        {"replayed", difference->replayed}};
  }
  result::put_answer(json, r.differing == 0 ? result::Answer::yes : result::Answer::no,
                     flight_log::replay_text(flight, r), made_with({options.log}));
  return json;
}

void verify(const ReplayOptions& options, const flight_log::Flight& flight, const Replayed& replayed) {
  if (options.json) {
    fmt::print("{}", to_json(options, flight, replayed).pretty());
  } else {
    show("{}: {}\n  {:.0f} ticks a second, {:.0f} times as fast as the flight\n", options.log,
         flight_log::replay_text(flight, replayed.result), replayed.ticks_per_s, replayed.ticks_per_s / 1000.0);
  }
  if (replayed.result.differing > 0) {
    throw RequirementNotMet{""};
  }
}

std::filesystem::path folder_of(const ReplayOptions& options) {
  return options.out.empty() ? std::filesystem::path{"out"} / "replay" / name_of_log(options.log)
                             : std::filesystem::path{options.out};
}

void show_what_if(const ReplayOptions& options, const flight_log::Flight& flight, const Replayed& flown) {
  const std::vector<input::Override> changes = input::parse_overrides(options.changes);
  const core::FlightPlan plan = flight_log::plan_for_replay(flight, options.log, changes);
  const flight_log::Regeneration changed = flight_log::replay(flight, options.log, plan);
  WhatIf result = what_if(flight, flown.result, changed);
  result.log = options.log;
  result.changes = options.changes;
  result.rejects_offset = plan.offset.rejection != core::OffsetRejection::none;
  give_up_if_interrupted();
  const std::filesystem::path folder = folder_of(options);
  const std::array<text::NamedFile, 2> files{
      {{"what_if.html", what_if_html(result)}, {"what_if.csv", what_if_csv(result)}}};
  text::OutputFolder{folder, {options.log}}.write(files);
  if (options.json) {
    json::Value json{{"log", options.log},
                     {"open_loop", true},
                     {"rejects_offset", result.rejects_offset},
                     {"changes", options.changes},
                     {"clock", "seconds from " + result.clock},
                     {"ticks", result.time_s.size()},
                     {"differing", result.differing},
                     {"first_difference_s", result.first_difference_s},
                     {"largest_difference_deg", text::degrees(result.largest_difference_rad)},
                     {"largest_difference_s", result.largest_difference_s},
                     {"flown_saturated_fraction", result.flown_saturated},
                     {"what_if_saturated_fraction", result.what_if_saturated}};
    result::put_answer(json, result::Answer::none,
                       fmt::format("Open loop: with the changes {} of {} ticks have another roll command or phase.",
                                   result.differing, result.time_s.size()),
                       made_with({options.log}, {}, options.changes));
    fmt::print("{}", json.pretty());
    return;
  }
  show("{}\n  page  {}\n  data  {}\n", what_if_text(result), (folder / "what_if.html").string(),
       (folder / "what_if.csv").string());
}

void run(const ReplayOptions& options) {
  Chapters chapters{"replay", 2, "reading " + options.log};
  flight_log::LogFile file = flight_log::read_log_file(options.log);
  const flight_log::Flight flight = take_flight(file, options.flight);
  chapters.next("replaying the flight");
  const Replayed flown = timed_replay(flight, options.log, flight_log::plan_for_replay(flight, options.log, {}));
  give_up_if_interrupted();
  chapters.end();
  if (options.changes.empty()) {
    verify(options, flight, flown);
  } else {
    show_what_if(options, flight, flown);
  }
}

void fill(const Verb& verb) {
  auto options = std::make_shared<ReplayOptions>();
  verb.option("LOG", options->log, "A flight log (.ftl), or a folder with a flight.ftl").offers(files).required();
  verb.option("--set", options->changes,
              "section.key=value: change one value of the plan and compute the commands in open loop; repeatable")
      .offers(changes_of_plan)
      .one_word_each_time();
  add_flight_choice(verb, options->flight);
  verb.option("--out", options->out, "With --set: folder for what_if.html and what_if.csv [out/replay/NAME]")
      .offers(folders);
  verb.flag("--json", options->json, "Print one JSON object");
  verb.examples(
      "Exit code 0: every output byte of every tick that could be replayed is as recorded; 1: one differs.\n"
      "Examples:\n"
      "  fantail replay out/tasha3_launch2    does this program repeat that flight exactly?\n"
      "  fantail replay flown.ftl --set controller.canard_limit_deg=9\n"
      "                                       commands of the law with a wider limit\n"
      "  fantail replay flown.ftl --set offset.rejection=integral\n"
      "                                       commands with integral action, in the recorded motion\n"
      "  fantail replay flash.ftl --flight 2 --json\n"
      "                                       one of several flights, for a script");
  verb.action([options] { run(*options); });
}

const VerbCode code{"replay", fill};

}  // namespace
}  // namespace fantail::tool
