// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "fantail/deliver.hpp"
#include "fantail/many_flights.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/terminal.hpp"
#include "input/shipped.hpp"
#include "text/degrees.hpp"
#include "text/output_folder.hpp"
#include "text/quoting.hpp"
#include "tune/results.hpp"

namespace fantail::tool {
namespace {

struct TuneOptions {
  ScenarioOptions scenario;
  std::string rejection;
  bool schedule = false;
  double margin_deg = text::degrees(tune::Request{}.phase_margin_rad);
  double settling_s = tune::Request{}.settling_s;
  double spread = tune::Request{}.spread;
  std::size_t flights = tune::Request{}.flights;
  unsigned threads = 0;
  std::string plan;
  bool force = false;
  std::string out;
  bool json = false;
};

/// The plan's own, where the command line names none and the plan has one.
core::OffsetRejection rejection(const std::string& word, core::OffsetRejection of_plan) {
  if (word.empty() && of_plan != core::OffsetRejection::none) {
    return of_plan;
  }
  return word == "none"       ? core::OffsetRejection::none
         : word.empty()       ? core::OffsetRejection::integral
         : word == "integral" ? core::OffsetRejection::integral
                              : core::OffsetRejection::observer;
}

std::string scenario_command(const TuneOptions& options) {
  std::string command = "fantail tune " + text::shell_word(options.scenario.scenario);
  for (const std::string& change : options.scenario.changes) {
    command += " --set " + text::shell_word(change);
  }
  for (const auto& [option, value] : {std::pair{" --seed ", options.scenario.seed}, {" --plan ", options.plan}}) {
    command += value.empty() ? "" : option + text::shell_word(value);
  }
  return command;
}

tune::Request request(const TuneOptions& options, const core::FlightPlan& plan) {
  return {.rejection = rejection(options.rejection, plan.offset.rejection),
          .schedule = options.schedule || plan.gain_schedule.speeds_count > 0,
          .phase_margin_rad = text::radians(options.margin_deg),
          .settling_s = options.settling_s,
          .spread = options.spread,
          .flights = options.flights,
          .threads = options.threads,
          .command = command_of(options.scenario),
          .scenario_command = scenario_command(options),
          .replaces = options.force,
          .version = FANTAIL_VERSION};
}

/// Beside a plan of one's own. One that is shipped belongs to the program, so there it is the working folder.
std::filesystem::path plan_file(const TuneOptions& options) {
  if (!options.plan.empty()) {
    return options.plan;
  }
  const input::Document document =
      input::Document::load(input::find_input(input::Shipped::scenario, options.scenario.scenario));
  input::Section top{document, ""};
  const std::filesystem::path old_file = input::find_named_input(input::Shipped::plan, document, top, "plan");
  const std::string name = old_file.stem().string() + "_tuned.toml";
  std::error_code unknown;
  const std::filesystem::path shipped = input::data_folder() / "firmware/plans";
  return std::filesystem::equivalent(old_file.has_parent_path() ? old_file.parent_path() : ".", shipped, unknown)
             ? std::filesystem::path{name}
             : old_file.parent_path() / name;
}

void refuse_to_replace(const std::filesystem::path& file, const TuneOptions& options) {
  for (const std::filesystem::path& made_from : files_of(options.scenario)) {
    if (std::error_code not_there; std::filesystem::equivalent(file, made_from, not_there)) {
      throw text::OutputError{file.string() + ": these results are made from it; choose another place for the plan"};
    }
  }
  if (!options.force && std::filesystem::exists(file)) {
    throw UsageError{file.string() + " already exists; --force replaces it, --plan FILE names another"};
  }
}

tune::Tuning tuned(const sim::Scenario& scenario, tune::Request asked, const runs::Place& place,
                   const runs::Folder& kept) {
  std::optional<Progress> flying;
  Progress searching{"searching gains for " + scenario.name, {.unit = "steps", .rate = " a second", .total = {}}};
  double steps = 0.0;
  asked.kept = &kept;
  return tune::tune(scenario, asked, [&](tune::Stage stage, std::size_t done) {
    leave_if_interrupted(place.folder, place.parts);
    if (stage != tune::Stage::flying) {
      searching.show(++steps);
      return;
    }
    if (!flying) {
      flying.emplace(
          "flying both plans",
          Progress::Measure{.unit = "pairs", .rate = " a second", .total = static_cast<double>(asked.flights)});
    }
    flying->show(static_cast<double>(done));
  });
}

void write(const std::filesystem::path& file, const std::string& content) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path{"."};
  text::OutputFolder{folder}.write(std::array{text::NamedFile{.name = file.filename().string(), .content = content}});
}

/// A scenario that is shipped names a shipped plan, and is not to be written into.
std::string how_to_fly(const TuneOptions& options, const std::filesystem::path& plan) {
  const std::filesystem::path scenario = input::find_input(input::Shipped::scenario, options.scenario.scenario);
  const std::filesystem::path folder =
      std::filesystem::weakly_canonical(std::filesystem::absolute(scenario)).parent_path();
  if (std::error_code unknown; std::filesystem::equivalent(folder, input::data_folder() / "sim/scenarios", unknown)) {
    return "in a scenario of your own";
  }
  const std::filesystem::path whole = std::filesystem::weakly_canonical(std::filesystem::absolute(plan));
  return fmt::format("in {}: plan = {}", scenario.string(),
                     text::toml_text(whole.lexically_relative(folder).generic_string()));
}

void tune_scenario(const TuneOptions& options) {
  const sim::Scenario scenario = load(options.scenario);
  const std::filesystem::path file = plan_file(options);
  refuse_to_replace(file, options);
  const std::vector<std::string> changes = changes_of(options.scenario);
  const std::filesystem::path folder = results_folder(options.out, "tune", scenario.name, changes);
  const runs::Place place = place_of_flights("tune", command_of(options.scenario), folder, files_of(options.scenario));
  const runs::Folder kept{place};
  const std::vector<std::filesystem::path> inputs = files_of(options.scenario);
  const result::Made made = made_with(inputs, scenario.seed, changes);
  const tune::Tuning tuning = tuned(scenario, request(options, scenario.plan), place, kept);
  const std::string plan_name = tuning.is_proposed() ? file.string() : "";
  deliver(tune::answer(tuning, plan_name, made),
          {.folder = folder,
           .name = "tune",
           .inputs = inputs,
           .json = options.json,
           .last_line = plan_name.empty()     ? "  plan     none written"
                        : !tuning.is_better() ? "           not better in flight: the present plan can stay"
                                              : "           name it " + how_to_fly(options, file),
           .when_written = [&] {
             if (tuning.is_proposed()) {
               write(file, tune::plan_text(tuning));
             }
             kept.remove();
           }});
  if (!tuning.is_proposed()) {
    throw RequirementNotMet{""};
  }
}

void fill(const Verb& verb) {
  auto options = std::make_shared<TuneOptions>();
  add_scenario_options(verb, options->scenario);
  verb.section("Law and aims");
  verb.option("--rejection", options->rejection,
              "How the law rejects a fin offset [as the plan does; integral where it does not]")
      .one_of({"none", "integral", "observer"})
      .changes_result();
  verb.flag("--schedule", options->schedule, "Let the gains change with speed [as the plan does]").changes_result();
  verb.option("--margin", options->margin_deg,
              "Phase margin in degrees that the law must have at every speed under control, over the spread")
      .range(0.0, 80.0)
      .value_name("DEG")
      .show_default()
      .changes_result();
  verb.option("--settling", options->settling_s,
              "Seconds after a step of the reference in which the linear loop must come within a tenth of the step, at "
              "the median speed and above")
      .range(0.05, 10.0)
      .value_name("S")
      .show_default()
      .changes_result();
  verb.option("--spread", options->spread,
              "Damping and torque may each be this many times larger or smaller than the vehicle's; 1: they are exact")
      .range(1.0, 4.0)
      .show_default()
      .changes_result();
  verb.section("Flights");
  verb.option("--flights", options->flights, "How many rockets of the spread to fly, each with both plans")
      .range(1.0, 10000.0)
      .show_default()
      .changes_result();
  add_threads_option(verb, options->threads);
  verb.section("Results");
  verb.option("--plan", options->plan,
              "The plan file to write [NAME_tuned.toml beside the old plan; for a shipped plan, in the working folder]")
      .offers(files)
      .value_name("FILE");
  verb.flag("--force", options->force, "Replace an existing plan file");
  verb.option("--out", options->out,
              "Folder for tune.html and tune.json [out/tune/SCENARIO, with the changes in the name]")
      .offers(folders);
  verb.flag("--json", options->json, "Print tune.json instead of the text");
  verb.examples(
      "To resume an interrupted search, give the same command again; it keeps the flights that were finished.\n"
      "Exit code 0: a plan was written; 1: none was, because no gains were found or the new plan loses flights.\n"
      "Examples:\n"
      "  fantail tune tasha3_launch2                          integral action, for a phase margin of 45 degrees\n"
      "  fantail tune my_rocket/scenario.toml --rejection observer --schedule --margin 50 --spread 2\n"
      "  fantail tune tasha3_launch1                          exit code 1: 6 degrees of canard cannot balance its "
      "offset\n"
      "  fantail tune tasha3_launch1 --set controller.canard_limit_deg=9");
  verb.action([options] { tune_scenario(*options); });
}

const VerbCode code{"tune", fill};

}  // namespace
}  // namespace fantail::tool
