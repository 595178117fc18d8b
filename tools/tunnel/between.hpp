// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace fantail::tunnel {

/// How far things differ among themselves when each was measured with an error: the scatter of the measured values is
/// that of the things and that of the measurement, on top of each other.
struct Between {
  double seen = 0.0;         ///< standard deviation of the measured values
  double measurement = 0.0;  ///< root mean square of their standard errors
  /// Standard deviation of the things: the variance seen without that of measurement, and zero where that explains all.
  double between = 0.0;
  double low = 0.0;  ///< where `between` lies with a probability of 95 %
  double high = 0.0;
};

/// At least two values and the standard error of each. The interval takes values and errors as normal, and is that of a
/// variance (chi-square): it holds the truth in 95 of 100 cases, and in a few more where measurement makes most of the
/// scatter.
[[nodiscard]] Between between_values(std::span<const double> values, std::span<const double> standard_errors);

}  // namespace fantail::tunnel
