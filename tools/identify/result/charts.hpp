// SPDX-License-Identifier: MIT
#pragma once

#include "identify/result/findings.hpp"
#include "plot/chart.hpp"
#include "plot/heat_map.hpp"

namespace fantail::identify::result {

// The pictures of one window, all methods in each. Time is that of the log.

[[nodiscard]] plot::Chart angle_chart(const WindowFindings& window);
[[nodiscard]] plot::Chart rate_chart(const WindowFindings& window);
/// Measured minus modelled.
[[nodiscard]] plot::Chart angle_residual_chart(const WindowFindings& window);
[[nodiscard]] plot::Chart rate_residual_chart(const WindowFindings& window);
/// As measured; in the closed loop also as the model commands.
[[nodiscard]] plot::Chart canard_chart(const WindowFindings& window);
/// With the band in which it lies with a probability of 95 %, every instant taken by itself.
[[nodiscard]] plot::Chart disturbance_chart(const WindowFindings& window);
/// The error over the number of intervals. For a result with trials.
[[nodiscard]] plot::Chart node_curve_chart(const Identification& result);
/// The error over alpha and beta with every winner that lies on the map. For a result with a map.
[[nodiscard]] plot::HeatMap error_map_chart(const WindowFindings& window, const model::ErrorMap& errors);

}  // namespace fantail::identify::result
