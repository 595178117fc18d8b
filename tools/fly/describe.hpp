// SPDX-License-Identifier: MIT
#pragma once

#include "flight/flight.hpp"
#include "sim/scenario.hpp"

namespace fantail::fly {

/// What is known of a flight before it is flown: what flies by which plan, and in notes what was assumed and is broken.
[[nodiscard]] flight::Flight describe(const sim::Scenario& scenario);

}  // namespace fantail::fly
