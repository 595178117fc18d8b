// SPDX-License-Identifier: MIT
#pragma once

#include "sil/random_launch.hpp"
#include "sim/scenario.hpp"

namespace fantail::sil {

/// A launch of a rocket that has nothing of a shipped one but its sensors: mass, motor (up to beyond the speed of
/// sound), drag, roll model, guide, servos, gains (good, weak, proportional only), time of control (half a second to a
/// minute), reference, fin offset and what is asked of the roll are drawn. One in ten has a fault.
[[nodiscard]] sim::Scenario any_rocket(Draw& draw);

}  // namespace fantail::sil
