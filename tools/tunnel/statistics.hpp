// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "tunnel/steady.hpp"
#include "tunnel/tunnel_log.hpp"

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

/// How much the speed of the air varies at one set point of the fan, as shares of its mean.
struct Unsteadiness {
  double share = 0.0;           ///< standard deviation, that of the sensor's rounding taken off
  double rounding_share = 0.0;  ///< that of the rounding: a smaller one cannot be seen
};

/// Of the air between two instants: of all readings of the steady segment that lies around them, because two or three
/// readings say little; without one of those in between. Empty: fewer than five readings, or no wind.
[[nodiscard]] std::optional<Unsteadiness> unsteadiness(const TunnelLog& wind, const SteadySegments& steady,
                                                       double begin_s, double end_s);

}  // namespace fantail::tunnel
