// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fantail::campaign {

struct FlownRun;

enum class Relation : std::uint8_t { is, at_least, at_most };

/// What a run must come to, to be counted: an outcome, or a figure on one side of a bound. A run without the figure,
/// or with one that is no number, does not meet it.
struct Question {
  Relation relation = Relation::is;
  std::string outcome = "held";  ///< for `is`
  std::size_t figure = 0;        ///< of figure_columns, for the others
  double bound = 0.0;            ///< in its unit, likewise

  [[nodiscard]] bool is_met_by(const FlownRun& run) const;
  /// Does this run count against the launch? It does not meet the question, or has an outcome that is not "held" and is
  /// asked for.
  [[nodiscard]] bool is_failed_by(const FlownRun& run) const;

  [[nodiscard]] std::string text() const;   ///< as parse_question() takes it
  [[nodiscard]] std::string words() const;  ///< "Outcome held", "Apogee at least 900 m"
};

/// "outcome=held", "apogee_m>=900", "largest_hold_error_deg<=5". Throws text::Error (usage).
[[nodiscard]] Question parse_question(std::string_view text);
/// Why it does not take this; empty: it does.
[[nodiscard]] std::string objection_to_question(const std::string& text);

}  // namespace fantail::campaign
