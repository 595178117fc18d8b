// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "brief/brief.hpp"

namespace fantail::brief {

/// Why landing() cannot be asked of this vehicle, a clause; empty: it can.
[[nodiscard]] std::string why_no_landing(const sim::Vehicle& vehicle);

/// Flies the scenario with each canard at each stop, from each instant on. Throws what hardover::fly() throws.
[[nodiscard]] Landing landing(const Request& request,
                              const std::function<void(std::size_t done, std::size_t of)>& look);

}  // namespace fantail::brief
