// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/scenario.hpp"

namespace fantail::fly {

/// What is broken, since when and by how much: "Fault: canard_stuck, canard 1, from 2.5 s after ignition."
[[nodiscard]] std::string fault_text(const sim::Fault& fault, const sim::Scenario& scenario);

}  // namespace fantail::fly
