// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flight_log/flight_log.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::flight_log {

/// Why a plan block holds no plan that can be used, as the end of a sentence.
[[nodiscard]] std::string words(const protocol::PlanBlockReading& reading);

/// What the plan of a flight is called: the shipped one with the same checksum, else "plan 1a2b3c4d". Empty without a
/// plan block.
[[nodiscard]] std::string plan_name(const Flight& flight);

}  // namespace fantail::flight_log
