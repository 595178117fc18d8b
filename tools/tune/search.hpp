// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario.hpp"
#include "stability/speed_range.hpp"
#include "tune/law.hpp"
#include "tune/request.hpp"
#include "tune/speeds_flown.hpp"

namespace fantail::tune {

/// What a search of the linear loop came to.
struct Found {
  std::vector<Law> laws{};  ///< the fastest to reject an offset first
  /// Where no law has the phase margin: the most that one has at its worst speed, and where that is.
  stability::MarginAtSpeed most{};
  /// Where no law with both margins settles in time: the shortest time that one takes; empty: none does at all.
  std::optional<double> shortest_settling_s{};
  bool phase_margin_is_there = false;
  bool gain_margin_is_there = false;
  std::string tried{};  ///< from where to where the numbers went
};

/// Of round numbers, the laws that reject an offset fastest, in the mean over the time under control, among those that
/// for every airframe of the spread
///   have the phase margin at every speed under control,
///   have a gain margin of two, either way, at the lowest, the median and the highest speed,
///   settle in time from the median speed on.
/// Without rejection of the offset they are those that rest nearest to the reference. Fastest is: the largest ki, or kp
/// times the bandwidth of the observer, or kp. One for every third of a decade of kp and every schedule, as far as it
/// is not many times slower than the fastest: what limits do to a law, the linear loop does not know. `look` is called
/// now and then and may throw to give up.
[[nodiscard]] Found search(const sim::Scenario& scenario, const SpeedsFlown& speeds, const Request& request,
                           const std::function<void()>& look);

}  // namespace fantail::tune
