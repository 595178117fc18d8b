// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "campaign/flown_run.hpp"
#include "campaign/runs_file.hpp"
#include "campaign/setup.hpp"

namespace fantail::campaign {

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

}  // namespace fantail::campaign
