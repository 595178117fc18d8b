// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/flight_plan.hpp"
#include "core/inputs.hpp"
#include "listen/imu_log.hpp"
#include "listen/range_end.hpp"
#include "logs/interpolator.hpp"

namespace fantail::listen {

/// One signal of a log at any time. It keeps a reference to the signal.
class Channel {
 public:
  /// `pad_end_s`: up to here the mean of the samples is what it reads before the log begins.
  Channel(const Signal& signal, double longest_gap_s, double pad_end_s);

  struct Sample {
    double value = 0.0;
    bool at_positive_end = false;
    bool at_negative_end = false;
  };

  /// Times in increasing order. Empty in a gap. A signal that the log does not have is zero. At an end is what reads as
  /// much: not the line that leads there.
  [[nodiscard]] std::optional<Sample> at(double time_s);

 private:
  const Signal& signal_;
  std::optional<RangeEnd> positive_;
  std::optional<RangeEnd> negative_;
  logs::Interpolator between_;
  double pad_ = 0.0;
};

/// What the hardware layer would have given of a log, tick by tick. It keeps a reference to the log.
class Sensors {
 public:
  Sensors(const ImuLog& log, double longest_gap_s, double pad_end_s, const core::FlightPlan& plan);

  /// Writes time and samples of one tick; in a gap the old samples stay, with their old time.
  void read(double time_s, core::Microseconds now, core::Inputs& inputs);

 private:
  Channel axial_, second_, y_, z_, roll_, pitch_, yaw_;
  bool has_second_;
  bool two_gyros_;
};

/// So soon after lift-off a height has to say something, or it is none of that flight.
constexpr double height_within_s = 5.0;

/// What the log's own height (a barometer's, mostly) says of the flight.
struct LogHeight {
  Signal above_pad{};  ///< m above its mean over the last second before lift-off, or above its first figure
  std::optional<double> apogee_s{};  ///< log's clock
  double apogee_m = 0.0;
};

/// Apogee is where a running median over 0.5 s is largest, after lift-off: the charge of a parachute and the passage of
/// Mach 1 put spikes into a barometer. Empty apogee: no lift-off, no height in the first five seconds after it, or one
/// that ends while it still rises. `until_s`: where another flight begins.
[[nodiscard]] LogHeight log_height(const Signal& height, std::optional<double> lift_off_s,
                                   std::optional<double> until_s = {});

}  // namespace fantail::listen
