// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "identify/result/findings.hpp"
#include "page/chart.hpp"
#include "page/heat_map.hpp"

namespace fantail::identify::result {

// The pictures of one window, all methods in each. Time is that of the log.

enum class Motion : std::uint8_t { angle, rate };

[[nodiscard]] page::Chart motion_chart(const WindowFindings& window, Motion motion);
/// Measured minus modelled.
[[nodiscard]] page::Chart residual_chart(const WindowFindings& window, Motion motion);
/// As measured; in the closed loop also as the model commands.
[[nodiscard]] page::Chart canard_chart(const WindowFindings& window);
/// With the band in which it lies with a probability of 95 %, every instant taken by itself.
[[nodiscard]] page::Chart disturbance_chart(const WindowFindings& window);
/// The error over the number of intervals. For a result with trials.
[[nodiscard]] page::Chart node_curve_chart(const Identification& result);
/// The error over alpha and beta with every winner that lies on the map. For a result with a map.
[[nodiscard]] page::HeatMap error_map_chart(const WindowFindings& window, const model::ErrorMap& errors);

}  // namespace fantail::identify::result
