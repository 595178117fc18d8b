// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace fantail::flight {

/// What a person would type to fly a scenario; `changes`: the words of --set, and seed= and trajectory=.
[[nodiscard]] std::string fly_command(const std::string& scenario, const std::vector<std::string>& changes);

}  // namespace fantail::flight
