// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "bench/exercise.hpp"
#include "bench/measurement.hpp"
#include "bench/verdict.hpp"
#include "sim/canard_tolerances.hpp"

namespace fantail::bench {

enum class Cause : std::uint8_t {
  healthy,
  stuck,               ///< does not move and stands off its centre
  dead,                ///< does not move and stands at its centre: no power, gear torn, or jammed there
  reversed,            ///< moves the other way
  slipping,            ///< moves the right way and loses a share of each movement
  slow,                ///< gets there, but late
  encoder_unplugged,   ///< nothing valid to read
  encoder_noisy,       ///< reads unsteadily at rest
  wrong_trim,          ///< moves right, and stands off by the same angle everywhere
  wrong_canard_moves,  ///< another canard answers, alone or too
  out_of_tolerance,    ///< some figure fails, with no pattern
  limit_not_kept,      ///< commanded beyond its limit
  not_measured,        ///< nothing it showed fails, but some figure could not be measured
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
