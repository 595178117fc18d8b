// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace fantail::stability {

/// The preferred numbers of IEC 60063, E24, from one end to the other, increasing: neighbours differ by a tenth.
[[nodiscard]] std::vector<double> round_numbers_between(double from, double to);

}  // namespace fantail::stability
