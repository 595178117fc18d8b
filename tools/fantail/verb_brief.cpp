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
#include "input/shipped.hpp"
#include "text/output_folder.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

namespace fs = std::filesystem;

struct BriefOptions {
  ScenarioOptions scenario;
  double step_s = 1.0;
  unsigned threads = 0;
  std::string out;
  bool json = false;
};

brief::Brief make(const BriefOptions& options, sim::Scenario scenario) {
  std::optional<Progress> progress;
  std::size_t winds = 0;
  std::size_t last_of = 0;
  const std::string name = scenario.name;
  return brief::make({.scenario = std::move(scenario), .step_s = options.step_s, .threads = options.threads},
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
  const std::vector<fs::path> inputs = files_of(options.scenario);
  const result::Made made = made_with(inputs, scenario.seed, changes);
  const brief::Brief made_brief = make(options, std::move(scenario));
  const result::Document document = brief::answer(made_brief, made);
  text::OutputFolder{folder, inputs}.write(std::vector<text::NamedFile>{
      {"brief.html", brief::page_html(made_brief, made)}, {"brief.json", result::json(document)}});
  deliver(document, {.json = options.json,
                     .last_line = fmt::format("  page     {}", text::printable((folder / "brief.html").string()))});
}

void fill(const Verb& verb) {
  auto options = std::make_shared<BriefOptions>();
  add_scenario_options(verb, options->scenario);
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
      "freedom if the vehicle has the section [airframe].\n"
      "Examples:\n"
      "  fantail brief tasha3_launch2                       the sheet of the shipped launch\n"
      "  fantail brief my_rocket.toml --set wind.speed_m_s=6 --set wind.from_deg=270\n"
      "                                                     your rocket, landing in wind from the west\n"
      "  fantail brief my_rocket.toml --step 0.25 --json    with more instants of failure, for a script");
  verb.action([options] { write_brief(*options); });
}

const VerbCode code{"brief", fill};

}  // namespace
}  // namespace fantail::tool
