// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "campaign/question.hpp"
#include "campaign/setup.hpp"
#include "fantail/deliver.hpp"
#include "fantail/many_flights.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "input/shipped.hpp"
#include "rare/margin.hpp"
#include "rare/study.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

namespace fs = std::filesystem;

struct RareOptions {
  ScenarioOptions scenario{.scenario = "tasha3_launch2", .seed = {}, .changes = {}};
  std::string question = "outcome=held";
  std::size_t flights = rare::Options{}.flights_a_level;
  std::optional<double> at_most{};
  unsigned threads = 0;
  std::string out;
  bool json = false;
};

std::string objection_to_search(const std::string& text) {
  const std::string objection = campaign::objection_to_question(text);
  return objection.empty() ? rare::objection_to(campaign::parse_question(text)) : objection;
}

void search(const RareOptions& options) {
  rare::Options asked{.campaign = {.scenario = options.scenario.scenario,
                                   .changes = input::parse_overrides(options.scenario.changes),
                                   .seed = options.scenario.seed.empty() ? campaign::seed_of(options.scenario.scenario)
                                                                         : *text::whole_number(options.scenario.seed)},
                      .question = campaign::parse_question(options.question),
                      .flights_a_level = options.flights,
                      .at_most = options.at_most,
                      .threads = options.threads};
  std::vector<std::string> changes = changes_of(options.scenario);
  const std::string name = input::name_of_file(options.scenario.scenario);
  const std::vector<fs::path> inputs = files_of(options.scenario);
  const result::Made made = made_with(inputs, asked.campaign.seed, changes);
  changes.push_back(asked.question.text());
  const fs::path folder = results_folder(options.out, "rare", name, changes);
  const std::string command =
      fmt::format("{} {} {}", command_of(options.scenario), asked.question.text(), options.flights);
  const runs::Place place = place_of_flights("rare", command, folder, inputs);
  const runs::Folder kept{place};
  asked.kept = &kept;
  rare::Study study;
  {
    Progress progress{"searching failures of " + name, {.unit = "flights", .rate = " a second", .total = {}}};
    study = rare::search(asked, [&](std::uint64_t done) {
      leave_if_interrupted(folder, place.parts);
      progress.show(static_cast<double>(done));
    });
  }
  Chapters chapters{"rare", 1, "flying the likeliest and the worst again, and writing the page"};
  rare::fly_again(study, folder, [&] { leave_if_interrupted(folder, place.parts); });
  chapters.end();
  study.made = made;
  study.options.kept = nullptr;
  deliver(rare::answer(study), {.folder = folder,
                                .name = "rare",
                                .inputs = inputs,
                                .json = options.json,
                                .yes_is_required = options.at_most.has_value(),
                                .when_written = [&kept] { kept.remove(); }});
}

}  // namespace

void fill_rare(const Verb& verb) {
  auto options = std::make_shared<RareOptions>();
  add_scenario_options(verb, options->scenario);
  verb.section("Question");
  verb.option("--share", options->question,
              "Which flights are good, so that the others fail: outcome=held, or a figure with >= or <= and a number. "
              "How often is "
              "it above 400 m? apogee_m<=400")
      .check(objection_to_search)
      .value_name("QUESTION")
      .show_default()
      .changes_result();
  verb.option("--at-most", options->at_most,
              "Require at most this probability of a failure; exit code 1 unless that is met, interval and all")
      .range(0.0, 1.0)
      .value_name("PROBABILITY");
  verb.section("Flights");
  verb.option("--flights", options->flights, "Flights of each level; each level is ten times rarer than the one before")
      .range(100.0, 1e6)
      .show_default()
      .changes_result();
  add_threads_option(verb, options->threads);
  verb.section("Results");
  verb.option("--out", options->out,
              "Folder for rare.html, rare.json and the flights that were flown again [out/rare/SCENARIO, with what was "
              "changed in the name]")
      .offers(folders);
  verb.flag("--json", options->json, "Print rare.json instead of the text");
  verb.examples(
      "Finds how probable a rare failure is, by subset simulation: each level begins at the worst tenth of the flights "
      "before it. To continue an interrupted search, repeat the command.\n"
      "Exit code 0: searched, and the requirement is met; 1: it is not met, or not decided.\n"
      "Examples:\n"
      "  fantail campaign rare tasha3_launch2                 how often in a million is the roll not held?\n"
      "  fantail campaign rare tasha3_launch2 --share 'apogee_m>=350' --at-most 1e-4\n"
      "                                                       is it rarer than 1 in 10 000 that it stays below 350 m?\n"
      "  fantail campaign rare my_rocket.toml --flights 1000  faster and less exact");
  verb.action([options] { search(*options); });
}

}  // namespace fantail::tool
