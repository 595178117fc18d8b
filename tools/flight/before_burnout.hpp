// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace fantail::flight {

/// What becomes of a simulated rocket whose motor has something left to give: a hundredth of its impulse or more. Times
/// on the rows' clock; empty: it did not happen.
struct BeforeBurnout {
  static constexpr double least_sunk_m = 1.0;

  std::optional<double> turned_over_s{};  ///< the motor pushes, and the nose points below the horizon
  double largest_tilt_rad = 0.0;          ///< from then on
  std::optional<double> sank_s{};  ///< beyond the guide, from its highest point up to then, by least_sunk_m or more
  double sank_m = 0.0;             ///< the most
  bool rose_again = false;         ///< beyond that point
  std::optional<double> parachute_s{};   ///< it began to open
  std::optional<double> ground_s{};      ///< it came down, the last time
  std::optional<double> left_again_s{};  ///< after that: it had stood on its pad again

  [[nodiscard]] bool happened() const { return ascent_failed() || ground_s; }
  /// A hop on the pad is none.
  [[nodiscard]] bool ascent_failed() const {
    return turned_over_s || sank_s || parachute_s || (ground_s && !left_again_s);
  }
};

}  // namespace fantail::flight
