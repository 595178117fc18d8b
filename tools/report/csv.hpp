// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/flight.hpp"

namespace fantail::report {

/// flight.csv: a header, then one row per tick with six decimals. What is unknown is an empty cell. The true_ columns
/// exist when any row has truth.
[[nodiscard]] std::string csv(const Flight& flight);

}  // namespace fantail::report
