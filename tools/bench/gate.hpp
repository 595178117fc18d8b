// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/flight_plan.hpp"

namespace fantail::bench {

/// Until when the canards stay at trim, as the end of a sentence: "past the largest dynamic pressure and 1700 m above
/// the launch site".
[[nodiscard]] std::string gate(const core::FlightPlan& plan);

}  // namespace fantail::bench
