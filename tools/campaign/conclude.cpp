// SPDX-License-Identifier: MIT
#include <utility>

#include <fmt/core.h>

#include "campaign/campaign.hpp"
#include "campaign/flown_run.hpp"
#include "campaign/results.hpp"
#include "campaign/setup.hpp"
#include "text/number.hpp"
#include "text/output_folder.hpp"
#include "text/quoting.hpp"

namespace fantail::campaign {
namespace {

namespace fs = std::filesystem;

constexpr int decimals = 6;  // of per cents

/// What a person types to fly it.
std::string command_of(const Campaign& campaign, const Question& question, std::optional<double> required) {
  std::string words = fmt::format("fantail campaign {} --runs {}", text::shell_word(campaign.scenario), campaign.runs);
  for (const input::Override& change : campaign.changes) {
    words += " --set " + text::shell_word(lines_of({change}));
  }
  if (campaign.seed != Campaign{}.seed) {
    words += fmt::format(" --seed {}", campaign.seed);
  }
  words += " --share " + text::shell_word(question.text());
  if (required) {
    words += " --at-least " + text::brief(100.0 * *required, decimals);
  }
  if (campaign.stop && campaign.stop->within) {
    words += " --until-within " + text::brief(100.0 * *campaign.stop->within, decimals);
  }
  return words + (campaign.stop && campaign.stop->required ? " --until-decided" : "");
}

/// The name of its folder; empty for a run whose files do not allow what it drew.
std::string write_run(const Campaign& campaign, const FlownRun& run, const fs::path& folder) {
  if (run.outcome == "refused") {
    return {};
  }
  std::string name = fmt::format("run_{}", run.run);
  RepeatedRun repeated = repeat_run(campaign, run.run);
  write_flight(repeated.scenario, std::move(repeated.changes), std::move(repeated.note), folder / name);
  return name;
}

}  // namespace

Report conclude(const Campaign& campaign, FlownCampaign flown, const Question& question, std::optional<double> required,
                const result::Made& made, const fs::path& folder, unsigned threads, const std::function<void()>& look) {
  Report report;
  report.analysis = analyse(flown, campaign, question, required);
  for (const RankedRun& worst : report.analysis.worst) {
    look();
    report.run_folders.push_back(write_run(campaign, flown.runs[worst.index], folder));
  }
  report.roll_band = roll_band_of(campaign, flown, look);
  report.landings = landings_of(campaign, flown, threads, look);
  report.campaign = campaign;
  report.flown = std::move(flown);
  report.made = made;
  report.command = command_of(campaign, question, required);
  report.run_command = fmt::format("fantail fly --campaign {} --run", text::shell_word(folder.string()));
  return report;
}

}  // namespace fantail::campaign
