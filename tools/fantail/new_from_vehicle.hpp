// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "airframe/new_rocket.hpp"
#include "input/document.hpp"
#include "sim/vehicle.hpp"

namespace fantail::tool {

/// Gives a source what every vehicle must have and `new` makes itself: a name and, where they are absent, the roll
/// model, and the roll inertia of weighed parts. `motor`: its absolute path, where the source may name none.
void add_computed_keys(input::Document& source, const std::optional<std::string>& motor);

/// Lets the new rocket keep what its shape says nothing of: drag over Mach, parachute, servos, sensors.
void keep_equipment(const input::Document& source, bool same_motor, airframe::NewRocket& rocket);

/// A sentence for each value of the source that is another one now, and one on the keys that were not kept.
[[nodiscard]] std::vector<std::string> changes(const input::Document& source, const sim::Vehicle& vehicle,
                                               const input::Document& made_file, const sim::Vehicle& made);

}  // namespace fantail::tool
