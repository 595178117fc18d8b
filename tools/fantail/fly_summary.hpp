// SPDX-License-Identifier: MIT
#pragma once

#include "flight/flight.hpp"
#include "report/results.hpp"

namespace fantail::tool {

/// What a flight came to, for a person.
void print_summary(const flight::Flight& flight, const report::Results& results);

}  // namespace fantail::tool
