// SPDX-License-Identifier: MIT
#pragma once

#include "flight/flight.hpp"

// Looks at the rows of a flight and shares no code with the report.
namespace fantail::sil {

/// What truly was, from the rows alone.
struct Oracle {
  bool controlled = false;
  double largest_error_deg = 0.0;  ///< from the settle point, a second after control start and after each step
  double judged_s = 0.0;           ///< how long some row counted for it
  double turned_after_deg = 0.0;   ///< from the end of control to apogee
  double end_before_apogee_s = 0.0;
  double largest_offset_deg = 0.0;  ///< under control
  double unbalanced_deg = 0.0;      ///< of the offset, by where the canards stand as control ends

  /// Whether control lasted to less than `margin_s` before apogee, whatever ended it.
  [[nodiscard]] bool lasted(double margin_s) const;
  /// Whether the roll stayed where the law settles, from the settling to there.
  [[nodiscard]] bool steady() const;
};

/// The verdict promises to stay within ten degrees, and prints two decimals of them.
inline constexpr double promised_deg = 10.0;
inline constexpr double rounding_deg = 0.01;

/// Control that ends less than half a second before apogee counts as a full flight; the rows are milliseconds apart.
inline constexpr double early_s = 0.5;
inline constexpr double rounding_s = 0.01;
/// Less is not judged.
inline constexpr double least_judged_s = 1.0;

Oracle look(const flight::Flight& flight);

}  // namespace fantail::sil
