// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "brief/brief.hpp"
#include "fantail/deliver.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fly/fly_scenario.hpp"
#include "input/shipped.hpp"
#include "rules/judge.hpp"
#include "text/output_folder.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

namespace fs = std::filesystem;

struct BriefOptions {
  ScenarioOptions scenario;
  std::string pack;
  double step_s = 1.0;
  unsigned threads = 0;
  std::string out;
  bool json = false;
};

std::optional<rules::Pack> pack_of(const BriefOptions& options) {
  return options.pack.empty() ? std::nullopt : std::optional{rules::load_pack(options.pack)};
}

/// As `fantail rules` judges it: the scenario as written, which may fly along a straight line.
brief::Rules held_against(const rules::Pack& pack, const ScenarioOptions& options) {
  const sim::Scenario scenario = load(options);
  const std::vector<rules::Judged> judged =
      rules::judge(pack, rules::subject_of(scenario, fly::fly_scenario(scenario)));
  brief::Rules found{.pack = fmt::format("{} ({})", pack.title, pack.date),
                     .sentence = rules::verdict(judged).sentence,
                     .caution = rules::caution(pack)};
  if (scenario.vehicle.airframe && scenario.motion != sim::FlightMotion::six_dof) {
    found.flown = "The rules judge the scenario as written, along a straight line.";
  }
  for (const rules::Judged& one : judged) {
    found.clauses.push_back({.id = one.clause.id, .outcome = std::string{rules::name(one.outcome)}});
  }
  return found;
}

brief::Brief make(const BriefOptions& options, const std::optional<rules::Pack>& pack, sim::Scenario scenario) {
  std::optional<Progress> progress;
  std::size_t winds = 0;
  std::size_t last_of = 0;
  const std::string name = scenario.name;
  std::optional<brief::Rules> rules = pack ? std::optional{held_against(*pack, options.scenario)} : std::nullopt;
  return brief::make({.scenario = std::move(scenario),
                      .step_s = options.step_s,
                      .threads = options.threads,
                      .rules = std::move(rules)},
                     [&](std::size_t done, std::size_t of) {
                       give_up_if_interrupted();
                       if (!progress || of != last_of) {
                         progress.emplace(
                             of == 0 ? "trying winds on " + name : "failing canards of " + name,
                             Progress::Measure{.unit = "flights",
                                               .rate = " a second",
                                               .total = of == 0 ? std::optional<double>{} : static_cast<double>(of)});
                         last_of = of;
                       }
                       progress->show(static_cast<double>(of == 0 ? winds++ : done));
                     });
}

void write_brief(const BriefOptions& options) {
  sim::Scenario scenario = load_in_six_dof(options.scenario);
  const std::vector<std::string> changes = changes_of(options.scenario);
  const fs::path folder = results_folder(options.out, "brief", input::name_of_file(options.scenario.scenario), changes);
  const std::optional<rules::Pack> pack = pack_of(options);
  std::vector<fs::path> inputs = files_of(options.scenario);
  if (pack) {
    inputs.emplace_back(pack->file);
  }
  const result::Made made = made_with(inputs, scenario.seed, changes);
  const brief::Brief made_brief = make(options, pack, std::move(scenario));
  const result::Document document = brief::answer(made_brief, made);
  text::OutputFolder{folder, inputs}.write(std::vector<text::NamedFile>{
      {"brief.html", brief::page_html(made_brief, made)}, {"brief.json", result::json(document)}});
  deliver(document, {.json = options.json,
                     .last_line = fmt::format("  page     {}", text::printable((folder / "brief.html").string()))});
}

void fill(const Verb& verb) {
  auto options = std::make_shared<BriefOptions>();
  add_scenario_options(verb, options->scenario);
  verb.option(
          "--rules", options->pack,
          "A rule pack whose clauses are checked: a shipped name (irec, euroc, launch_canada, nar_tripoli) or a path")
      .offers(shipped(input::Shipped::rules))
      .value_name("PACK")
      .changes_result();
  verb.option("--step", options->step_s, "Seconds between the instants at which a canard fails")
      .range(0.01, 10.0)
      .value_name("S")
      .show_default()
      .belongs_to_command();
  add_threads_option(verb, options->threads);
  verb.option("--out", options->out, "Folder for brief.html and brief.json [out/brief/SCENARIO]").offers(folders);
  verb.flag("--json", options->json, "Print brief.json instead of the text");
  verb.examples(
      "brief.html is one page of A4: print it, fill in the blanks and sign it. All flights are in six degrees of "
      "freedom if the vehicle has the section [airframe]. Only the rules judge the scenario as written, as fantail "
      "rules does.\n"
      "Examples:\n"
      "  fantail brief tasha3_launch2 --rules irec          the sheet of the shipped launch, with a competition's "
      "rules\n"
      "  fantail brief my_rocket.toml --set wind.speed_m_s=6 --set wind.from_deg=270\n"
      "                                                     your rocket, landing in wind from the west\n"
      "  fantail brief my_rocket.toml --step 0.25 --json    with more instants of failure, for a script");
  verb.action([options] { write_brief(*options); });
}

const VerbCode code{"brief", fill};

}  // namespace
}  // namespace fantail::tool
