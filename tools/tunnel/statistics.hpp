// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace fantail::tunnel {

/// At least one value.
[[nodiscard]] double mean(std::span<const double> values);

struct Moments {
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< of a sample: squares over one less than the number of values
};

/// At least two values: one says nothing of a deviation.
[[nodiscard]] Moments moments(std::span<const double> values);

/// A mean and how well it is known.
struct KnownMean {
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< of the samples
  double standard_error = 0.0;      ///< of the mean
  double independent_samples =
      1.0;  ///< that the samples are worth: fewer than there are when neighbours resemble each other
};

/// Of at least two samples at an even distance. How long they remember each other is found from their own
/// autocorrelation, summed until a lag of five times the time found so far (Sokal); long records are averaged in blocks
/// first, which leaves the error of the mean as it is.
[[nodiscard]] KnownMean known_mean(std::span<const double> samples);

/// y = offset + slope x by least squares.
struct Line {
  double slope = 0.0;
  double offset = 0.0;
  double r_squared = 1.0;
};

/// At least two points that do not all share one x.
[[nodiscard]] Line fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace fantail::tunnel
