// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "sim/scenario.hpp"

namespace fantail::tool {

/// How far from its reference the roll comes to rest, rad. Empty where that is not the same all the time.
[[nodiscard]] std::optional<double> settles_off_rad(const sim::Scenario& scenario);

}  // namespace fantail::tool
