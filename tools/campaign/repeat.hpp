// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "sim/scenario.hpp"

namespace fantail::campaign {

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
