// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fantail::campaign {

/// What a column of runs.csv or a drawn quantity is called where a person reads it, and its unit, which may be empty:
/// "largest hold error" and "deg" of largest_hold_error_deg, "servo: lag, factor" of servo.lag_s_factor, "disturbance:
/// angles, added" and "deg" of disturbance.angles_deg_offset.
struct ColumnWords {
  std::string words;
  std::string unit;

  /// "largest hold error / deg".
  [[nodiscard]] std::string with_unit() const { return unit.empty() ? words : words + " / " + unit; }
};
[[nodiscard]] ColumnWords column_words(std::string_view name);

/// "cut short" of cut_short.
[[nodiscard]] std::string outcome_words(std::string outcome);

}  // namespace fantail::campaign
