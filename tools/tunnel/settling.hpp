// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace fantail::tunnel {

/// From which sample on a value that follows a new set point has settled: what is left of the change is below a quarter
/// of its scatter. The last half of the change is fitted with an exponential, because scatter hides its end. The number
/// of samples when it never settles. `least_scatter` is what the sensor's rounding makes; lists of the same length.
[[nodiscard]] std::size_t settled_from(std::span<const double> time_s, std::span<const double> value,
                                       double least_scatter);

}  // namespace fantail::tunnel
