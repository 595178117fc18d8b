// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
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
  limit_reported,  ///< after a request beyond it, the avionics must report that it limited the command
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

/// One figure compared with its tolerance, in display units.
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

/// Slew rate that a canard must show in a step this wide. A short movement ends before a good servo is at full
/// speed, so no more is required than a lag that just passes the step time reaches.
[[nodiscard]] double required_slew_rad_s(double way_rad, const sim::CanardTolerances& tolerances);

/// Limit beyond the trim, to both sides, with which a movement is judged; less shows neither scale nor speed.
[[nodiscard]] double least_travel_rad();
[[nodiscard]] bool too_little_travel(const Bounds& bounds, std::size_t canard);

/// How far another canard may go along with one that moves alone. No vehicle needs more: encoders and linkages are
/// separate.
[[nodiscard]] double most_others_move_rad();

enum class Cause : std::uint8_t {
  healthy,
  stuck,               ///< does not move and stands off its centre
  dead,                ///< does not move and stands at its centre: no power, gear torn, or jammed there
  reversed,            ///< moves the other way
  slipping,            ///< moves the right way and loses a share of each movement
  slow,                ///< gets there, but late
  encoder_unplugged,   ///< nothing valid to read
  encoder_noisy,       ///< reads unsteadily at rest
  wrong_trim,          ///< follows, but is off by the same angle everywhere
  wrong_canard_moves,  ///< another canard moves, alone or as well
  out_of_tolerance,    ///< some figure fails, with no pattern
  limit_not_kept,      ///< commanded beyond its limit
  not_measured,        ///< no measured figure fails, but some could not be measured
};
[[nodiscard]] std::string_view name(Cause cause);        ///< for files: "reversed", as the faults of a scenario
[[nodiscard]] std::string_view cause_text(Cause cause);  ///< for readers: "is reversed"

struct Diagnosis {
  Cause cause = Cause::healthy;
  std::string seen;     ///< a sentence with numbers, without the canard: "commanded to +6.0 deg, it went to -6.0 deg"
  std::string look_at;  ///< a sentence for the person at the bench; empty when healthy
};

/// The one cause that explains the most. `checks` are those of check() for these figures.
[[nodiscard]] Diagnosis diagnose(const Figures& figures, std::span<const Check> checks, const Bounds& bounds,
                                 std::size_t canard, const sim::CanardTolerances& tolerances);

/// "Canard 3 is reversed: ...". `canard` counts from 0.
[[nodiscard]] std::string sentence(std::size_t canard, const Diagnosis& diagnosis);
/// With other words for the cause.
[[nodiscard]] std::string sentence(std::size_t canard, std::string_view cause, const Diagnosis& diagnosis);

}  // namespace fantail::bench
