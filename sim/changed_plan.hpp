// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/flight_plan.hpp"
#include "sim/document.hpp"

namespace fantail::sim {

/// `plan` with some of its values changed, read and checked as from a file; every other value keeps all its bits.
/// Throws InputError (bad_configuration).
[[nodiscard]] core::FlightPlan changed_plan(const core::FlightPlan& plan, std::span<const Override> changes);

}  // namespace fantail::sim
