// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>

#include "campaign/setup.hpp"
#include "runs/runner.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::campaign {

RepeatedRun repeat_run(const Campaign& campaign, std::uint64_t run) {
  if (run >= campaign.runs) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      fmt::format("run {}; allowed: 0 to {}", run, campaign.runs - 1)};
  }
  input::ScenarioFiles files = files_of(campaign);
  const Draw draw = drawer_of(campaign, spreads_of(campaign, files)).draw(run);
  RepeatedRun repeated;
  for (const input::Override& change : campaign.changes) {
    repeated.changes.push_back(lines_of({change}));
  }
  repeated.note =
      fmt::format("Run {} of a campaign of {} with seed {}; drawn for it:", run, campaign.runs, campaign.seed);
  for (const input::Override& change : draw.changes) {
    files.apply(change);
    repeated.note += (repeated.note.ends_with(':') ? " " : ", ") + lines_of({change});
  }
  repeated.note += '.';
  repeated.scenario = files.read();
  repeated.scenario.seed = runs::seed_of_run(campaign.seed, run);
  repeated.scenario.changed_values = repeated.changes.size() + draw.changes.size();
  return repeated;
}

Campaign campaign_in(const std::filesystem::path& folder, const std::string& version) {
  const Identity there = read_identity(folder);
  const std::string file = (folder / identity_name).string();
  const auto said = [&](std::string_view name) -> const std::string& {
    const auto found = std::ranges::find(there, name, &Identity::value_type::first);
    if (found == there.end()) {
      throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: {} is missing", file, name)};
    }
    return found->second;
  };
  const auto whole = [&](std::string_view name) {
    if (const auto number = text::whole_number(said(name))) {
      return *number;
    }
    throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: {} is not a whole number", file, name)};
  };
  if (const std::string objection = objection_to_sampling(said("sampling")); !objection.empty()) {
    throw text::Error{text::ErrorKind::bad_data, file + ": " + objection};
  }
  Campaign campaign{
      .scenario = said("file"), .changes = changes_in(said("changes")), .seed = whole("seed"), .runs = whole("runs")};
  const input::ScenarioFiles files = files_of(campaign);
  Identity here = identity_of(campaign, files, spreads_of(campaign, files), version);
  std::erase_if(here, [](const auto& entry) { return entry.first == "stop" || entry.first == "shard"; });
  if (const std::string differs = runs::difference(there, "there", here, "now"); !differs.empty()) {
    throw text::Error{text::ErrorKind::bad_configuration, file + ": this campaign cannot be flown again: " + differs};
  }
  return campaign;
}

}  // namespace fantail::campaign
