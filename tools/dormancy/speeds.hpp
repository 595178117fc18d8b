// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sim/scenario.hpp"

namespace fantail::dormancy {

/// Air speeds at which the loop of a scenario is closed, of every row under control, in order. As
/// fly::speeds_under_control_m_s() has them, and behind a gate later than the guide down to slowest_held_m_s: such a
/// rocket has its highest speed behind it when control begins.
[[nodiscard]] std::vector<double> speeds_under_control_m_s(const sim::Scenario& scenario);

}  // namespace fantail::dormancy
