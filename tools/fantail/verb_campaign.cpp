// SPDX-License-Identifier: MIT
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "campaign/campaign.hpp"
#include "campaign/results.hpp"
#include "campaign/setup.hpp"
#include "fantail/deliver.hpp"
#include "fantail/many_flights.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

namespace fs = std::filesystem;

struct CampaignOptions {
  ScenarioOptions scenario{.scenario = "tasha3_launch2", .seed = {}, .changes = {}};
  std::size_t runs = 1000;
  std::string sampling = "independent";
  std::string question = "outcome=held";
  std::optional<double> at_least_percent;
  std::optional<double> until_within_percent;
  bool until_decided = false;
  std::string shard = "1/1";
  unsigned threads = 0;
  std::string out;
  bool json = false;
};

struct MergeOptions {
  std::vector<std::string> shards;
  std::string out;
};

std::optional<campaign::Shard> parse_shard(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto number = text::whole_number(text.substr(0, slash));
  const auto of = slash == std::string_view::npos ? std::nullopt : text::whole_number(text.substr(slash + 1));
  return number && of && *number >= 1 && *number <= *of ? std::optional{campaign::Shard{.number = *number, .of = *of}}
                                                        : std::nullopt;
}

std::string objection_to_shard(const std::string& text) {
  return parse_shard(text) ? "" : '"' + text + "\" is not a shard; allowed: NUMBER/OF, 1/4 to 4/4";
}

std::optional<double> share(const std::optional<double>& percent) {
  return percent ? std::optional{*percent / 100.0} : std::nullopt;
}

campaign::Campaign asked_for(const CampaignOptions& options) {
  campaign::Campaign campaign{.scenario = options.scenario.scenario,
                              .changes = input::parse_overrides(options.scenario.changes),
                              .seed = options.scenario.seed.empty() ? campaign::seed_of(options.scenario.scenario)
                                                                    : *text::whole_number(options.scenario.seed),
                              .runs = options.runs,
                              .shard = *parse_shard(options.shard)};
  if (options.until_within_percent || options.until_decided) {
    campaign.stop =
        campaign::StopRule{.question = campaign::parse_question(options.question),
                           .within = share(options.until_within_percent),
                           .required = options.until_decided ? share(options.at_least_percent) : std::nullopt};
  }
  return campaign;
}

/// What makes the runs others than those of the scenario as it stands; the question does only when it stops them.
std::vector<std::string> changes_of(const CampaignOptions& options) {
  std::vector<std::string> all = changes_of(options.scenario);
  if (const auto stop = asked_for(options).stop) {
    all.push_back("until=" + stop->text());
  }
  return all;
}

fs::path folder_of(const CampaignOptions& options) {
  const std::string name = input::name_of_file(options.scenario.scenario);
  return results_folder(options.out, "campaign", name, changes_of(options));
}

campaign::FlownCampaign fly(const campaign::Campaign& campaign, const fs::path& folder, unsigned threads) {
  const std::uint64_t total = campaign::runs_of_shard(campaign.runs, campaign.shard).count;
  Progress progress{"flying " + input::name_of_file(campaign.scenario),
                    {.unit = "runs", .rate = " a second", .total = static_cast<double>(total)}};
  return campaign::fly_campaign(campaign, folder, FANTAIL_VERSION, threads, [&](std::uint64_t done) {
    leave_if_interrupted(folder);
    progress.show(static_cast<double>(done));
  });
}

/// A part is not judged.
result::Document answer_of_shard(const campaign::Shard& shard, std::size_t runs, const std::string& file,
                                 const result::Made& made) {
  return {.title = fmt::format("shard {} of {}", shard.number, shard.of),
          .subtitle = fmt::format("{} in {}", text::counted(runs, "run"), file),
          .verdict = {.answer = result::Answer::none,
                      .heading = "Flown",
                      .sentence = "Merge all shards to answer the question."},
          .facts = {{"shard", "", shard.number}, {"of", "", shard.of}, {"runs", "", runs}, {"file", "", file}},
          .made = made};
}

void fly_campaign(const CampaignOptions& options) {
  const campaign::Campaign campaign = asked_for(options);
  const fs::path folder = folder_of(options);
  const std::vector<fs::path> inputs = files_of(options.scenario);
  const result::Made made = made_with(inputs, campaign.seed, changes_of(options));
  campaign::FlownCampaign flown = fly(campaign, folder, options.threads);
  const std::string runs = (folder / campaign::runs_name).string();
  if (!flown.remark.empty()) {
    say("fantail: " + flown.remark + "\n");
  }
  if (campaign.shard.of > 1) {
    deliver(answer_of_shard(campaign.shard, flown.runs.size(), runs, made), {.json = options.json});
    return;
  }
  Chapters chapters{"campaign", 1, "computing the figures, flying the worst flights again and writing the page"};
  const campaign::Report report = campaign::conclude(
      campaign, std::move(flown), campaign::parse_question(options.question), share(options.at_least_percent), made,
      folder, options.threads, [&] { leave_if_interrupted(folder, campaign::runs_name); });
  chapters.end();
  deliver(campaign::answer(report), {.folder = folder,
                                     .name = "summary",
                                     .page = "campaign",
                                     .inputs = inputs,
                                     .json = options.json,
                                     .last_line = "  runs     " + runs});
  if (report.analysis.judgement && *report.analysis.judgement != campaign::Judgement::met) {
    throw RequirementNotMet{""};
  }
}

void merge(const MergeOptions& options) {
  const std::vector<fs::path> shards{options.shards.begin(), options.shards.end()};
  Chapters chapters{"merge", 1, fmt::format("joining the runs of {} shards", shards.size())};
  const std::uint64_t runs = campaign::merge(shards, options.out);
  chapters.end();
  show("{}, {}: {}\n", text::counted(shards.size(), "shard"), text::counted(runs, "run"),
       (fs::path{options.out} / campaign::runs_name).string());
  show("No answer yet: repeat the command of the shards without --shard and with --out {}; no run is flown again.\n",
       text::shell_word(options.out));
}

void fill_merge(const Verb& verb) {
  auto options = std::make_shared<MergeOptions>();
  verb.option("SHARDS", options->shards, "The folders of all shards of one campaign, in any order")
      .offers(folders)
      .required();
  verb.option("--out", options->out, "Folder for the whole campaign: the same bytes as if flown in one piece")
      .offers(folders)
      .required();
  verb.examples(
      "Then repeat the command of the shards without --shard and with the same --out: it flies nothing and writes the "
      "page.\n"
      "Examples:\n"
      "  fantail campaign merge shard_1 shard_2 --out whole\n"
      "  fantail campaign tasha3_launch2 --runs 10000 --out whole");
  verb.action([options] { merge(*options); });
}

void fill(const Verb& verb) {
  auto options = std::make_shared<CampaignOptions>();
  add_scenario_options(verb, options->scenario);
  verb.option("--runs", options->runs, "Largest number of flights").range(1.0, 1e8).show_default().changes_result();
  verb.option("--sampling", options->sampling, "Every run is drawn independently; the only method")
      .check(campaign::objection_to_sampling)
      .value_name("independent");
  verb.section("Question and when to stop");
  verb.option("--share", options->question,
              "Which runs are counted: outcome=WORD, or a figure with >= or <= and a number, as in apogee_m>=900")
      .check(campaign::objection_to_question)
      .value_name("QUESTION")
      .show_default();
  auto at_least =
      verb.option("--at-least", options->at_least_percent,
                  "Require this share in per cent; exit code 1 unless the whole interval is at or above it");
  at_least.range(0.0, 100.0).value_name("PERCENT");
  verb.option("--until-within", options->until_within_percent,
              "Stop as soon as the share is known to within this many per cent, up or down")
      .range(0.1, 50.0)
      .value_name("PERCENT");
  verb.flag("--until-decided", options->until_decided,
            "Stop as soon as the whole interval is above or below --at-least")
      .needs(at_least);
  verb.section("Machines and processors");
  verb.option("--shard", options->shard, "Fly one part of OF parts, one part per machine; see campaign merge")
      .check(objection_to_shard)
      .value_name("NUMBER/OF")
      .changes_result();
  add_threads_option(verb, options->threads);
  verb.section("Results");
  verb.option("--out", options->out,
              "Folder for runs.csv.gz, band.csv, campaign.json, summary.json, campaign.html and the worst runs "
              "[out/campaign/SCENARIO, with what was changed in the name]")
      .offers(folders);
  verb.flag("--json", options->json, "Print summary.json instead of the text");
  verb.examples(
      "To continue an interrupted campaign, repeat the command.\n"
      "Exit code 0: flown, and the requirement is met; 1: it is not met, or not decided. A shard ends with 0 when it "
      "is flown.\n"
      "Examples:\n"
      "  fantail campaign tasha3_launch2 --runs 10000        how often does it hold its roll, and which quantities "
      "matter?\n"
      "  fantail campaign tasha3_launch2 --share 'apogee_m>=420' --at-least 20 --until-decided\n"
      "                                                      as many flights as it takes to say yes or no\n"
      "  fantail campaign my_rocket.toml --runs 100000 --shard 3/8 --out shard_3\n"
      "                                                      part 3 of 8, for one of eight machines");
  fill_faults(
      verb.verb("faults", "Break every device in every phase of the flight, and check whether the rocket stays safe"));
  fill_merge(verb.verb("merge", "Put the shards of a campaign together"));
  fill_hardover(verb.verb("hardover", "Effect of one failed canard on the flight"));
  fill_detection(verb.verb("detection", "How often an armed rocket detects a false launch, or misses its launch"));
  fill_rare(verb.verb("rare", "How often in a million a flight fails, and by what"));
  verb.action([options] { fly_campaign(*options); });
}

const VerbCode code{"campaign", fill};

}  // namespace
}  // namespace fantail::tool
