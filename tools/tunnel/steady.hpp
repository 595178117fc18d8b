// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tunnel/tunnel_log.hpp"

namespace fantail::tunnel {

/// A stretch in which neither fan nor air changes.
struct SteadySegment {
  std::optional<double> fan_rpm{};  ///< empty for a log that does not say
  double begin_s = 0.0;             ///< of its first reading
  double end_s = 0.0;               ///< of its last
  std::size_t first = 0;            ///< reading
  std::size_t count = 0;
};

struct SteadyOptions {
  double shortest_s = 20.0;     ///< a segment that is shorter, or has fewer than five readings, is none
  double rpm_tolerance = 10.0;  ///< a reading of the fan further off than this is a new set point
};

/// A stretch that a person names. Without an end it lasts until the fan's next set point, the next stretch or the end
/// of the log.
struct NamedStretch {
  double begin_s = 0.0;
  std::optional<double> end_s{};
};

struct SteadySegments {
  std::vector<SteadySegment> found;
  std::vector<std::string> left_out;  ///< set points that never became steady, a sentence each
};

/// For each set point of the fan above zero: when the air has settled. What is left of the change is followed as an
/// exponential, which tells when it has sunk below a quarter of the scatter long before scatter and rounding let one
/// see it. That survives a sensor that rounds to 0.1 m/s and shows the same value for a minute.
[[nodiscard]] SteadySegments find_steady(const TunnelLog& log, const SteadyOptions& options);

/// The same with times by hand. Throws text::Error (bad_configuration) for a stretch with fewer than two readings.
[[nodiscard]] SteadySegments take_steady(const TunnelLog& log, const std::vector<NamedStretch>& stretches,
                                         const SteadyOptions& options);

/// From which sample on a value that follows a new set point has settled: what is left of the change is below a quarter
/// of its scatter. The last half of the change is fitted with an exponential, because scatter hides its end. The number
/// of samples when it never settles. `least_scatter` is what the sensor's rounding makes; lists of the same length.
[[nodiscard]] std::size_t settled_from(std::span<const double> time_s, std::span<const double> value,
                                       double least_scatter);

/// "100,230:300,390": begins, or begin and end. Empty: not such a list, or times that do not increase.
[[nodiscard]] std::optional<std::vector<NamedStretch>> parse_stretches(std::string_view text);

/// The coarsest usual step, in m/s, km/h, mph, knots or feet a second, that all speeds (m/s) are multiples of: what a
/// sensor rounds to. Zero when there is none.
[[nodiscard]] double rounding_of(const std::vector<double>& values);

/// Standard deviation that rounding alone makes: a twelfth of the step squared, as of a value that is equally likely
/// anywhere within the step.
[[nodiscard]] double rounding_deviation(double step);

}  // namespace fantail::tunnel
