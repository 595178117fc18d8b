// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flight/flight.hpp"
#include "sim/scenario.hpp"
#include "stability/speed_range.hpp"

namespace fantail::fly {

/// Where a simulated flight went beyond what the model holds for, a sentence each: a guide that leans (the simulated
/// rocket keeps to the line of its guide), speeds near that of sound (for constant coefficients, or for the
/// Prandtl-Glauert factor), a thrust beyond the range of the accelerometers, and wind at the end of the guide. In the
/// tunnel, too: fins that reverse the roll, and servos too weak for the plan's limit.
[[nodiscard]] std::vector<std::string> beyond_the_model(const sim::Scenario& scenario, const flight::Flight& flight);

/// Of every tick under control. Near apogee nothing flows: the lowest speed that counts is that at which control began,
/// the first of the list.
[[nodiscard]] std::vector<double> speeds_under_control_m_s(const flight::Flight& flight);

/// From the lowest to the highest of them. Empty without control.
[[nodiscard]] std::optional<stability::SpeedRange> speed_range_under_control(const flight::Flight& flight);

/// The margins of the roll loop at the speed at which control begins, and at the median, the top and the worst speed
/// from there on, by speed. Empty without control and where the gain of the loop never reaches one.
[[nodiscard]] std::vector<flight::LoopMargin> loop_margins(const sim::Scenario& scenario, const flight::Flight& flight);

}  // namespace fantail::fly
