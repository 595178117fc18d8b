// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "flight/flight.hpp"

// What a roll that is called held is held against: the truth of the rows and four plain demands. It knows neither the
// law nor where that settles, nor why control ended; no code of the report, of the flight's own helpers or of its
// events.
namespace fantail::sil {

/// What truly was.
struct PlainTruth {
  bool controlled = false;
  double judged_s = 0.0;      ///< under control, a second after its begin and after each change of R
  double farthest_deg = 0.0;  ///< then, from R
  double mean_deg = 0.0;      ///< over all control, from R
  double rest_deg = 0.0;      ///< largest size of the mean of phi - R over a judged stretch of a second or more
  double end_early_s = 0.0;   ///< from the end of control to the greatest height
  double turned_deg = 0.0;    ///< between those two, from where the roll was as control ended
  double top_mach = 0.0;      ///< by the standard atmosphere
};

/// `elevation_m`: of the launch site above the sea.
[[nodiscard]] PlainTruth look_plainly(std::span<const flight::Row> rows, double elevation_m);

/// Why that is not a roll that was held within `limit_deg` of its reference, a clause each; empty: it may be called so.
[[nodiscard]] std::vector<std::string> not_held_because(const PlainTruth& truth, double limit_deg);

/// Likewise, wherever it rested and at whatever speed.
[[nodiscard]] std::vector<std::string> not_steady_because(const PlainTruth& truth);

}  // namespace fantail::sil
