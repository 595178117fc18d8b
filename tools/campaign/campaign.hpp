// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/flown_run.hpp"
#include "campaign/runs_file.hpp"
#include "campaign/stop_rule.hpp"
#include "sim/scenario.hpp"

namespace fantail::campaign {

/// Many flights of one scenario, whose file says what is not known in tables [[spread]].
struct Campaign {
  std::string scenario{};                  ///< shipped name or path
  std::vector<input::Override> changes{};  ///< the same in every run
  std::uint64_t seed = 1;                  ///< of all runs
  std::uint64_t runs = 1'000;              ///< 1 or more
  Shard shard{};                           ///< of these runs; the others are left to others
  std::optional<StopRule> stop{};          ///< not of a shard
};

/// What was flown.
struct FlownCampaign {
  std::string scenario{};  ///< names, as a flight report has them
  std::string vehicle{};
  std::string plan{};
  std::vector<std::string> quantities{};  ///< what was drawn, as the columns of runs.csv
  std::vector<FlownRun> runs{};           ///< of its shard, or as many as its rule asked for
  std::string remark{};                   ///< a sentence for who asked; empty: nothing to remark
};

/// The runs of a shard, which is one.
[[nodiscard]] inline Stretch runs_of_shard(std::uint64_t runs, const Shard& shard) {
  return runs::share_of(shard, runs, runs_of_a_part);
}

/// Flies every run of its shard that `folder` does not hold yet, as runs::run() does, and writes runs.csv.gz: its bytes
/// depend on the campaign alone, not on threads, order, or where it was interrupted. `version`: of the program, which
/// is part of what a campaign is.
///
/// Throws text::Error before anything is flown for no runs, a shard that is none of its parts, a rule that cannot hold,
/// no spread, a spread that cannot be drawn, a draw that a field does not allow, or a folder with another campaign.
[[nodiscard]] FlownCampaign fly_campaign(const Campaign& campaign, const std::filesystem::path& folder,
                                         const std::string& version, unsigned threads,
                                         const std::function<void(std::uint64_t done)>& look);

/// Puts the runs of all shards of one campaign into the folder `out`: the bytes of runs.csv.gz and of campaign.json are
/// those of the campaign flown as one. `shards`: their folders, in any order. Returns how many runs there are.
///
/// Throws text::Error, and writes nothing: no_such_input for a folder in which no shard was finished; bad_configuration
/// for shards of different campaigns (naming what differs), one that is there twice or missing, by its number; bad_data
/// for runs that are damaged, or not those of the shard.
std::uint64_t merge(std::span<const std::filesystem::path> shards, const std::filesystem::path& out);

/// One run of a campaign, to be flown again.
struct RepeatedRun {
  sim::Scenario scenario{};
  std::vector<std::string> changes{};  ///< of the whole campaign: "body.mass_kg=4.1"
  std::string note{};                  ///< which run it is, and what was drawn for it: a sentence for its report
};

/// Throws text::Error for a run that is none of its runs, or whose files do not allow what it draws together.
[[nodiscard]] RepeatedRun repeat_run(const Campaign& campaign, std::uint64_t run);

/// The campaign that was flown in a folder, or is on its way there. Throws text::Error: no_such_input without one,
/// bad_data for a file that does not say all of it, bad_configuration when scenario, plan, vehicle, motor, a table
/// or the program's `version` is not what it was.
[[nodiscard]] Campaign campaign_in(const std::filesystem::path& folder, const std::string& version);

}  // namespace fantail::campaign
