// SPDX-License-Identifier: MIT
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "fantail/deliver.hpp"
#include "fantail/flown_vehicle.hpp"
#include "fantail/log_info.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "flight_log/flight_log.hpp"
#include "fly/describe.hpp"
#include "fly/fly_scenario.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "logs/flight_file.hpp"
#include "protocol/log_header.hpp"
#include "rules/judge.hpp"
#include "rules/record.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

struct RulesOptions {
  std::string pack;
  ScenarioOptions scenario{};  ///< or a log
  std::optional<std::string> vehicle;
  std::optional<std::size_t> flight;
  std::string out;
  bool json = false;
};

/// A folder or a file that is there and no TOML is a log; all else names a scenario.
bool is_log(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto kind = std::filesystem::status(path, ignored).type();
  const bool is_shipped = path.extension().empty() && kind != std::filesystem::file_type::directory;
  return path.extension() != ".toml" && !is_shipped;
}

void refuse_unless_launch(bool is_launch, const std::string& name) {
  if (!is_launch) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      name + ": not a launch; allowed: a scenario or a log of a launch"};
  }
}

struct Held {
  rules::Subject subject{};
  result::Made made{};
  std::vector<std::filesystem::path> inputs{};
  std::string name{};  ///< of its results
};

/// A canard that nothing commanded shows little.
Held hold_scenario(const RulesOptions& options, const std::filesystem::path& pack) {
  if (options.vehicle) {
    throw UsageError{"--vehicle names the rocket of a log, and " + options.scenario.scenario +
                     " is a scenario, which names its own"};
  }
  if (options.flight) {
    throw UsageError{"--flight chooses one of a log, and " + options.scenario.scenario + " is a scenario"};
  }
  const sim::Scenario scenario = load(options.scenario);
  refuse_unless_launch(
      scenario.surroundings == sim::Surroundings::flight && scenario.plan.run.start == core::Start::launch,
      scenario.name);
  const std::vector<std::string> changes = changes_of(options.scenario);
  Held held{.inputs = files_of(options.scenario), .name = variant_name(scenario.name, changes)};
  held.inputs.insert(held.inputs.begin(), pack);
  held.made = made_with(held.inputs, scenario.seed, changes);
  Progress progress{"flying " + scenario.name, {.unit = "s", .rate = " x real time", .total = {}}};
  const flight::Flight flight = fly::fly_scenario(scenario, [&progress](double simulated_s) {
    give_up_if_interrupted();
    progress.show(simulated_s);
  });
  held.subject = rules::subject_of(scenario, flight);
  return held;
}

/// Of a folder its log, which alone has the attitude.
std::filesystem::path recorded(const std::filesystem::path& log) {
  std::error_code ignored;
  const std::filesystem::path inside = log / "flight.ftl";
  return std::filesystem::exists(inside, ignored) ? inside : log;
}

/// With the rests of that flight after resets.
flight::Flight read_log(const RulesOptions& options) {
  const std::filesystem::path path = recorded(options.scenario.scenario);
  const std::filesystem::path file = logs::flight_file(path);
  if (!logs::is_flight_log(file)) {
    if (options.flight) {
      throw UsageError{fmt::format("--flight {}: {} is a table of one flight", *options.flight, path.string())};
    }
    return logs::read_flight(path);
  }
  flight_log::LogFile log = flight_log::read_log_file(file);
  if (options.flight || !flight_log::is_one_flight(log)) {
    const std::size_t chosen = options.flight.value_or(1);
    std::vector<flight_log::Flight> kept{take_flight(log, options.flight)};
    for (std::size_t i = chosen; i < log.flights.size() && flight_log::is_rest_of(log.flights[i], kept.back()); ++i) {
      kept.push_back(std::move(log.flights[i]));
    }
    log.flights = std::move(kept);
  }
  return logs::replayed_flight(log);
}

/// A board that is built by itself names no rocket in its log.
void refuse_other_rocket(const sim::Vehicle& vehicle, const std::string& file, const std::string& flown) {
  const std::string name = text::printable(vehicle.name.substr(0, protocol::log_text_size));
  if (!flown.empty() && name != flown) {
    throw text::Error{
        text::ErrorKind::bad_configuration,
        fmt::format("{}: name = \"{}\", and the log is of the rocket \"{}\"; allowed: the vehicle of that "
                    "flight",
                    file, name, flown)};
  }
}

/// What its rocket tells: figures of its own, and how long its motor burns.
void add_log_and_rocket(const RulesOptions& options, const flight::Flight& flight, Held& held) {
  const FlownVehicle flown = flown_vehicle(options.scenario.scenario, options.vehicle);
  if (!flown.document) {
    held.subject.no_rocket = flown.why_unknown;
    held.subject.found = rules::of_log(flight);
    return;
  }
  const sim::Vehicle vehicle = input::read_vehicle(*flown.document);
  held.inputs.emplace_back(flown.document->file());
  refuse_other_rocket(vehicle, flown.document->file(), flight.vehicle);
  held.subject.what += fmt::format(", with the rocket {}{}", vehicle.name,
                                   flight.vehicle.empty() ? ", which the log does not name" : "");
  const double burns_s = vehicle.motor.burnout_s();
  held.subject.found = rules::of_log(flight, burns_s > 0.0 ? std::optional{burns_s} : std::nullopt);
  held.subject.found.merge(rules::of_rocket(vehicle, fly::side_moment_m3(vehicle), held.subject.found));
}

Held hold_log(const RulesOptions& options, const std::filesystem::path& pack) {
  const std::string& log = options.scenario.scenario;
  if (!changes_of(options.scenario).empty()) {
    throw UsageError{log + " is a log, which --set and --seed cannot change"};
  }
  Held held{.inputs = {pack, log}, .name = name_of_log(log)};
  const flight::Flight flight = read_log(options);
  refuse_unless_launch(!flight.tunnel, log);
  if (options.flight) {
    held.name += fmt::format("_{}", *options.flight);
  }
  held.subject.what = fmt::format("{}{}, as it was recorded{}{}", log,
                                  options.flight ? fmt::format(", flight {}", *options.flight) : "",
                                  flight.known.plan ? "" : ", without a flight plan",
                                  flight.differing_ticks > 0 ? ", whose replay differs" : "") +
                      (flight.known.phase ? rules::control_in_log(flight).of_subject : "");
  held.subject.why_missing =
      flight.known.plan ? "a log does not tell it" : "a table without a flight plan does not tell it";
  add_log_and_rocket(options, flight, held);
  if (flight.known.plan) {
    held.subject.found.merge(rules::of_plan(flight.plan));
    held.subject.found.merge(rules::of_law());
  }
  held.made = made_with(held.inputs);
  return held;
}

void check_rules(const RulesOptions& options) {
  const rules::Pack pack = rules::load_pack(options.pack);
  const Held held =
      is_log(options.scenario.scenario) ? hold_log(options, pack.file) : hold_scenario(options, pack.file);
  const std::string name =
      fmt::format("{}+{}{}", pack.name, held.name, is_log(options.scenario.scenario) ? "_flown" : "");
  deliver(rules::answer(pack, held.subject, rules::judge(pack, held.subject), held.made),
          {.folder = results_folder(options.out, "rules", short_name(name), {}),
           .name = "rules",
           .inputs = held.inputs,
           .json = options.json,
           .yes_is_required = true});
}

void fill(const Verb& verb) {
  auto options = std::make_shared<RulesOptions>();
  verb.option(
          "PACK", options->pack,
          "A rule pack: a shipped name (irec, euroc, launch_canada, nar_tripoli) or a path to a TOML file of your own")
      .offers(shipped(input::Shipped::rules))
      .required();
  add_scenario_options(verb, options->scenario,
                       ", which is flown once. Or a flight log (.ftl), a table with the columns of flight.csv, or a "
                       "flight folder");
  verb.option("--vehicle", options->vehicle,
              "The rocket of a log: a shipped name or a path [the shipped one in the flight's summary.json]")
      .offers(shipped(input::Shipped::vehicle))
      .value_name("NAME|FILE");
  add_flight_choice(verb, options->flight);
  verb.option("--out", options->out,
              "Folder for rules.html and rules.json [out/rules/PACK+SCENARIO, with the changes in the name; of a log "
              "out/rules/PACK+LOG_flown]")
      .offers(folders);
  verb.flag("--json", options->json, "Print rules.json instead of the text");
  verb.examples(
      "Exit code 0: no clause fails and each figure is known; clauses that the team must show may be left. 1: a clause "
      "fails, or could not be judged. The packs are our words and no legal advice: check against the current "
      "document.\n"
      "Examples:\n"
      "  fantail rules irec tasha3_launch2                  may this plan fly there, clause by clause?\n"
      "  fantail rules irec flown.ftl --vehicle rocket.toml did the canards stand at trim as long as they had to?\n"
      "  fantail rules my_range.toml tasha3_launch2 --json  a pack of your own, for a script");
  verb.action([options] { check_rules(*options); });
}

const VerbCode code{"rules", fill};

}  // namespace
}  // namespace fantail::tool
