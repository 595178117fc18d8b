// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "sim/input/field.hpp"
#include "sim/scenario.hpp"

namespace fantail::sim::input {

/// Everything that a scenario file may say, its faults apart.
[[nodiscard]] std::span<const Field<Scenario>> scenario_fields();

/// A shipped name or a path, with changes from the command line, which may reach into the scenario, its plan or its
/// vehicle. Throws InputError.
[[nodiscard]] Scenario load_scenario(const std::string& name_or_path, std::span<const Override> changes);

}  // namespace fantail::sim::input
