// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flight/flight.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"

namespace fantail::report {

/// summary.json: every key is always there; what does not exist is null. Angles in degrees, ends with a newline.
[[nodiscard]] std::string summary_json(const flight::Flight& flight, const Figures& figures, const Verdict& verdict);

}  // namespace fantail::report
