// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "flight/flight.hpp"
#include "rules/figures.hpp"

namespace fantail::rules {

struct Recorded {
  bool is_log;    ///< or a simulation, which has no holes
  bool is_whole;  ///< its rows reach the end of the ascent
};

/// flight.burnout_s, of a flight with rows. `ascent` are its rows up to the end of the ascent. The axial force alone
/// tells no more than when the thrust was last above the drag: where the simulation has no such event, the burn-out is
/// known by `motor_burns_s`, of the thrust curve. The plan's burn time proves nothing.
[[nodiscard]] Finding burnout_s(const flight::Flight& flight, std::span<const flight::Row> ascent,
                                const Recorded& recorded, const std::optional<double>& motor_burns_s);

}  // namespace fantail::rules
