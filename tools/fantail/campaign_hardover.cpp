// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fantail/deliver.hpp"
#include "fantail/many_flights.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "hardover/study.hpp"
#include "input/shipped.hpp"

namespace fantail::tool {
namespace {

namespace fs = std::filesystem;

struct HardoverOptions {
  ScenarioOptions scenario{.scenario = "tasha3_launch2", .seed = {}, .changes = {}};
  hardover::Options study;
  std::string failure = "hard_over";
  std::string out;
  bool json = false;
};

void fly(const HardoverOptions& options) {
  const sim::Scenario scenario = load_in_six_dof(options.scenario);  // first: what is no scenario has no name
  const std::vector<std::string> changes = changes_of(options.scenario);
  hardover::Options asked = options.study;
  if (options.failure == "cut_pulses") {
    asked.failure = hardover::Failure::cut_pulses;
  }
  const std::string name = input::name_of_file(options.scenario.scenario);
  const fs::path folder = results_folder(options.out, "hardover", name, changes);
  const std::vector<fs::path> inputs = files_of(options.scenario);
  const result::Made made = made_with(inputs, scenario.seed, changes);
  const runs::Place place = place_of_flights("hardover", command_of(options.scenario), folder, inputs);
  const runs::Folder kept{place};
  asked.kept = &kept;
  std::optional<Progress> progress;
  hardover::Study study = hardover::fly(scenario, asked, [&](std::size_t done, std::size_t of) {
    leave_if_interrupted(folder, place.parts);
    if (!progress) {
      progress.emplace("flying " + variant_name(name, changes),
                       Progress::Measure{.unit = "flights", .rate = " a second", .total = static_cast<double>(of)});
    }
    progress->show(static_cast<double>(done));
  });
  progress.reset();
  study.made = made;
  deliver(hardover::answer(study),
          {.folder = folder, .name = "hardover", .inputs = inputs, .json = options.json, .when_written = [&kept] {
             kept.remove();
           }});
}

}  // namespace

void fill_hardover(const Verb& verb) {
  auto options = std::make_shared<HardoverOptions>();
  add_scenario_options(verb, options->scenario);
  verb.option("--failure", options->failure,
              "How the canard fails: it runs to a stop for good (both stops are flown), or its pulses are cut short "
              "for 20 ms")
      .one_of({"hard_over", "cut_pulses"})
      .show_default()
      .changes_result();
  verb.option("--step", options->study.step_s, "Seconds between the instants at which a canard fails")
      .range(0.01, 10.0)
      .value_name("S")
      .show_default()
      .belongs_to_command();
  verb.option("--coupler", options->study.coupler_m,
              "Station of the bending moment: distance from the tip of the nose in metres, within the rocket")
      .range(0.0, 30.0)
      .value_name("M")
      .belongs_to_command();
  add_threads_option(verb, options->study.threads);
  verb.option("--out", options->out, "Folder for hardover.html and hardover.json [out/hardover/SCENARIO]")
      .offers(folders);
  verb.flag("--json", options->json, "Print hardover.json instead of the text");
  verb.examples(
      "All flights are in six degrees of freedom, whatever the scenario says. To continue an interrupted study, repeat "
      "the command.\n"
      "Examples:\n"
      "  fantail campaign hardover tasha3_launch2 --coupler 0.62\n"
      "                                       for the safety officer: force, bending moment, path, apogee\n"
      "  fantail campaign hardover tasha3_launch2 --set wind.speed_m_s=6 --step 0.1\n"
      "                                       the same in wind, with more instants\n"
      "  fantail campaign hardover my_rocket.toml --json");
  verb.action([options] { fly(*options); });
}

}  // namespace fantail::tool
