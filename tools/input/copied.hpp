// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/document.hpp"
#include "sim/scenario.hpp"

// A file that was copied from a shipped one and edited still says whose it was, until somebody changes that, too.
namespace fantail::input {

/// Asks about a name or assumptions of a shipped vehicle in a file that is not shipped; empty: nothing to ask.
[[nodiscard]] std::optional<std::string> question_about_vehicle(const Document& document, const sim::Vehicle& vehicle);

/// Asks about assumptions of a shipped scenario, or a shipped tunnel result beside a vehicle that is not shipped.
[[nodiscard]] std::vector<std::string> questions_about_scenario(const Document& scenario_file,
                                                                const Document& vehicle_file,
                                                                const sim::Scenario& scenario);

}  // namespace fantail::input
