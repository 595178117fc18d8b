// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "faults/flown_cell.hpp"

namespace fantail::faults {

/// Of what makes a flight this one and no other, beside its scenario: a digest of the first twin, of a few flights with
/// a fault, and of the table. Another one when simulator, flight law, judge or table make something else of them.
[[nodiscard]] std::string fingerprint(const Twins& twins);

}  // namespace fantail::faults
