// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "bench/axes.hpp"
#include "core/flight_plan.hpp"

namespace fantail::bench {

/// How the sensors would have to stand in the plan for these turns to be right: of all ways in which they can be
/// soldered in, the one next to `believed`, the plan with which the turns were seen, under which judge_axes() finds
/// nothing wrong. Empty: none, because gyro and accelerometer of one package do not agree, or a scale is wrong.
[[nodiscard]] std::optional<core::SensorsPlan> mounting_of(const TurnsSeen& seen, const core::SensorsPlan& believed);

/// What differs from `believed`, as lines of a plan; empty when nothing does.
[[nodiscard]] std::string mounting_lines(const core::SensorsPlan& found, const core::SensorsPlan& believed);

}  // namespace fantail::bench
