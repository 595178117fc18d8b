// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flight/flight.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"

namespace fantail::report {

/// A flight in one picture for sharing, 1200 x 630: its verdict in words, how far it rolled, and how far it would have
/// rolled without control where that is known. SVG with colours of its own, in the fonts DejaVu Sans or any other.
[[nodiscard]] std::string card_svg(const flight::Flight& flight, const Figures& figures, const Verdict& verdict);

}  // namespace fantail::report
