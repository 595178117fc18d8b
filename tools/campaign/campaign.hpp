// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/flown_run.hpp"
#include "campaign/runs_file.hpp"
#include "campaign/stop_rule.hpp"

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

}  // namespace fantail::campaign
