// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/avionics.hpp"

namespace fantail::boards::stm32f405 {

/// From now on a crash sends the canards to the trim of the plan that is then in force. Before that it leaves the
/// servos as they are, which is off. The avionics outlives everything.
void centre_on_crash(const avionics::Avionics& avionics);

}  // namespace fantail::boards::stm32f405
