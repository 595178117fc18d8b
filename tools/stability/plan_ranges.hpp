// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace fantail::stability {

/// What a plan may say, in SI and radians.
struct PlanRange {
  double minimum = 0.0;
  double maximum = 0.0;
};

/// Of a field of the plan. Throws std::logic_error for one that is not there.
[[nodiscard]] PlanRange plan_range(std::string_view section, std::string_view key);

}  // namespace fantail::stability
