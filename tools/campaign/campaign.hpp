// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "campaign/flown_run.hpp"
#include "campaign/unit_points.hpp"

namespace fantail::campaign {

/// Many flights of one scenario, whose file says what is not known in tables [[spread]].
struct Campaign {
  std::string scenario{};                  ///< shipped name or path
  std::vector<input::Override> changes{};  ///< the same in every run
  std::uint64_t seed = 1;                  ///< of all runs
  std::uint64_t runs = 1'000;              ///< 1 or more
  Sampling sampling = Sampling::independent;
};

/// Flies every run that `folder` does not hold yet, a chunk at a time on each thread, and writes runs.csv.gz: its bytes
/// depend on the campaign alone, not on threads, order, or where it was interrupted. What `look` throws ends it; chunks
/// that are finished stay, and the next call goes on from them. `look` is called with the runs done, several times a
/// second, from this thread. `version`: of the program, which is part of what a campaign is.
///
/// Throws text::Error before anything is flown for no runs, no spread, a spread that cannot be drawn, a draw that a
/// field does not allow, or a folder with another campaign.
[[nodiscard]] std::vector<FlownRun> fly_campaign(const Campaign& campaign, const std::filesystem::path& folder,
                                                 const std::string& version, unsigned threads,
                                                 const std::function<void(std::uint64_t done)>& look);

/// One run alone: the same as in fly_campaign().
[[nodiscard]] FlownRun fly_run_alone(const Campaign& campaign, std::uint64_t run);

}  // namespace fantail::campaign
