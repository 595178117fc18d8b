// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "identify/study.hpp"

namespace fantail::identify {

// What the page says of a window.

/// The one that the summary speaks of: without a grid's steps where there is one.
[[nodiscard]] const Identification& main_result(const WindowFindings& window);

/// Does it tell damping and torque?
[[nodiscard]] bool tells(const WindowFindings& window);

/// How well each number of a result with an uncertainty is known, and why, for someone who flies rockets.
[[nodiscard]] std::vector<std::string> how_well_sentences(const Identification& result);

/// With the signs that a terminal may not have: plus-minus, squares.
[[nodiscard]] std::string printable(std::string text);

/// "alpha and beta are ..." as a sentence of its own.
[[nodiscard]] std::string sentence(std::string text);

}  // namespace fantail::identify
