// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/scenario.hpp"

namespace fantail::tool {

/// How far from its reference the roll comes to rest, rad. Empty where that is not the same all the time.
[[nodiscard]] std::optional<double> settles_off_rad(const sim::Scenario& scenario);

/// What a person would type to fly it; `changes`: the words of --set, and seed= and trajectory=.
[[nodiscard]] std::string command_of(const std::string& scenario, const std::vector<std::string>& changes);

}  // namespace fantail::tool
