// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fantail/command_line.hpp"
#include "flight/flight.hpp"

namespace fantail::tool {

/// --card.
void add_card_option(const Verb& verb, bool& wanted);

/// Looks for what draws the card before a flight is flown in vain. Throws std::runtime_error that names the package.
void check_card_program();

/// The SVG as a PNG file, drawn by rsvg-convert. Throws std::runtime_error.
[[nodiscard]] std::string png_of(const std::string& svg);

/// A line on a name in letters that the card's own font does not have; else nothing.
[[nodiscard]] std::string note_on_letters(const flight::Flight& flight);

}  // namespace fantail::tool
