// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/scenario.hpp"

namespace fantail::campaign {

/// Flies one run of a campaign alone and writes its flight report, as `fantail fly` does, into a folder. `changes`: of
/// the whole campaign; `note`: which run it is, a sentence. Throws text::OutputError.
void write_flight(const sim::Scenario& scenario, std::vector<std::string> changes, std::string note,
                  const std::filesystem::path& folder);

}  // namespace fantail::campaign
