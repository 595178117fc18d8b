// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "flight/flight.hpp"

// What a flight log can prove: where its rows have a hole, nobody saw what happened.
namespace fantail::rules {

/// Rows that are farther apart have a hole between them.
inline constexpr double longest_step_s = 0.1;

struct Hole {
  double from_s = 0.0;
  double to_s = 0.0;  ///< infinity: the record ends
};

/// Those that hide a part of this span; its first row may come so much later.
[[nodiscard]] std::vector<Hole> holes(std::span<const flight::Row> rows, double from_s, double to_s);

/// "the record misses 4.00 to 8.50 s", "the record ends at 4.99 s"; empty: nothing is missing
[[nodiscard]] std::string missing_text(const std::vector<Hole>& holes);
/// What is known, and that.
[[nodiscard]] inline std::string with_missing(const std::string& how, const std::vector<Hole>& hidden) {
  return how + (how.empty() || hidden.empty() ? "" : "; ") + missing_text(hidden);
}

/// Apogee, whenever control ended: the true one, or where the avionics noticed it, or the greatest height of a record
/// that goes on. Canards stay on the rocket until then.
[[nodiscard]] std::optional<double> end_of_ascent(const flight::Flight& flight);

/// "3 ticks of the record differ from their replay", so its rows are not what was recorded; empty: none does.
[[nodiscard]] std::string differing_text(const flight::Flight& log);

/// Between launch and the end of the ascent.
[[nodiscard]] std::vector<Hole> holes_of_ascent(const flight::Flight& log);

/// "control never began" is said only by a record without holes.
struct ControlInLog {
  std::optional<double> start_s{};   ///< with rows around it
  std::optional<double> first_s{};   ///< earlier: a hole from here on may hide control that a gate ended again
  std::optional<double> before_s{};  ///< up to here it had not begun, as far as the rows show it; empty: nobody knows
  bool never_began = false;
  std::string why_unknown{};  ///< "the record misses 4.00 to 8.50 s, so it does not show when control began"
  std::string of_subject{};   ///< ", in which control never began"; empty: it began
};
[[nodiscard]] ControlInLog control_in_log(const flight::Flight& log);

}  // namespace fantail::rules
