// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "input/field.hpp"
#include "sim/scenario.hpp"

namespace fantail::input {

/// Everything that a scenario file may say, its faults apart.
[[nodiscard]] std::span<const Field<sim::Scenario>> scenario_fields();

/// A shipped name or a path, with changes from the command line, which may reach into the scenario, its plan or its
/// vehicle. Throws text::Error.
[[nodiscard]] sim::Scenario load_scenario(const std::string& name_or_path, std::span<const Override> changes);

}  // namespace fantail::input
