// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "campaign/results.hpp"

namespace fantail::campaign {

/// Analyses a whole campaign that was flown into `folder`, and writes there the flight reports of its worst runs, each
/// in a folder run_N. `required`: a share that is asked for. `look` is called before each of these flights; what it
/// throws ends it. Throws text::OutputError.
[[nodiscard]] Report conclude(const Campaign& campaign, FlownCampaign flown, const Question& question,
                              std::optional<double> required, const result::Made& made,
                              const std::filesystem::path& folder, const std::function<void()>& look);

}  // namespace fantail::campaign
