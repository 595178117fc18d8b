// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/exercise.hpp"
#include "bench/measurement.hpp"
#include "sim/canard_tolerances.hpp"

namespace fantail::bench {

enum class Measure : std::uint8_t {
  sign,
  reached_positive,
  reached_negative,
  reached,  ///< of a step: held against the angle commanded
  limit_kept,
  limit_reported,  ///< asked beyond it, the avionics has to say that it gave less
  tracking_error,
  centring_error,
  backlash,
  slew,
  step_time,
  noise,
  dropouts,
  amplitude_ratio,  ///< of a sine
  others_moved,
};

/// One figure held against its tolerance, in the units in which people read it.
struct Check {
  Measure measure{};
  std::optional<double> value{};  ///< empty: could not be measured, and so not passed
  std::optional<double> lowest{};
  std::optional<double> highest{};
  bool passed = false;
};

struct MeasureText {
  std::string_view key;  ///< in JSON
  std::string_view label;
  std::string_view unit;  ///< "deg", "deg/s", "s", "%", or empty
  int decimals;
};
[[nodiscard]] const MeasureText& text_of(Measure measure);
/// "at most 0.50", "5.50 to 6.50", "yes".
[[nodiscard]] std::string allowed_text(const Check& check);

/// Every figure of one turn of `limits`.
[[nodiscard]] std::vector<Check> check(const Figures& figures, const Bounds& bounds, std::size_t canard, bool alone,
                                       const sim::CanardTolerances& tolerances);

/// Commanded farther than the limit that the avionics itself reported.
[[nodiscard]] bool beyond_limit(const Figures& figures, double limit_rad);

/// Slew rate that a canard must show in a step this wide. A short way ends before a good servo is at full speed: no
/// more is asked than a lag that just passes the step time reaches.
[[nodiscard]] double required_slew_rad_s(double way_rad, const sim::CanardTolerances& tolerances);

/// Limit beyond the trim, to both sides, with which a movement is judged; less shows neither scale nor speed.
[[nodiscard]] double least_travel_rad();
[[nodiscard]] bool too_little_travel(const Bounds& bounds, std::size_t canard);

/// How far another canard may go along with one that moves alone. No vehicle needs more: encoders and linkages are
/// separate.
[[nodiscard]] double most_others_move_rad();

}  // namespace fantail::bench
