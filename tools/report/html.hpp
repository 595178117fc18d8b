// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flight/flight.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"

namespace fantail::report {

/// report.html: one page that loads nothing. Verdict, figures, tables and a picture of the roll angle are plain HTML;
/// where scripts run, plots with a common cursor take the picture's place.
[[nodiscard]] std::string html(const flight::Flight& flight, const Figures& figures, const Verdict& verdict);

}  // namespace fantail::report
