// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/document.hpp"
#include "input/shipped.hpp"
#include "sim/scenario.hpp"

// What is asked of whole files, once their keys have been read. All that is refused throws text::Error
// (bad_configuration).
namespace fantail::input {

/// Refuses a file that has no key of the wanted kind but some of another kind of file, and says which kind it is. Only
/// scenarios, vehicles and plans are told apart.
void refuse_other_kind(const Document& document, Shipped wanted);

/// Refuses a shape that cannot be: parts outside the rocket, lists of unequal length, keys that need others, and a
/// shape that is not the one of [airframe].
void check_geometry(const Document& document, const sim::Vehicle& vehicle);

/// Refuses centres of gravity and inertias of an [airframe] that no rocket of this mass, length and propellant can
/// have. For a flight that they decide: in another one, a mass or motor that is changed alone is a fair question.
/// `document` is the vehicle's; it has an airframe.
void check_balance(const Document& document, const sim::Vehicle& vehicle);

// A file that was copied from a shipped one and edited still says whose it was, until somebody changes that, too.

/// Asks about a name or assumptions of a shipped vehicle in a file that is not shipped; empty: nothing to ask.
[[nodiscard]] std::optional<std::string> question_about_vehicle(const Document& document, const sim::Vehicle& vehicle);

/// Asks about assumptions of a shipped scenario, or a shipped tunnel result beside a vehicle that is not shipped.
[[nodiscard]] std::vector<std::string> questions_about_scenario(const Document& scenario_file,
                                                                const Document& vehicle_file,
                                                                const sim::Scenario& scenario);

}  // namespace fantail::input
