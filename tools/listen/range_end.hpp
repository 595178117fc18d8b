// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "listen/imu_log.hpp"

namespace fantail::listen {

/// Where a sensor seems to stand at the end of its range: its largest reading, of one sign.
struct RangeEnd {
  double value = 0.0;       ///< SI and radians
  std::size_t samples = 0;  ///< that stand there
  double longest_s = 0.0;   ///< of the longest stretch
  double first_s = 0.0;     ///< log's clock

  /// Does a reading stand there?
  [[nodiscard]] bool holds(double reading) const;
};

enum class Side : bool { negative, positive };

/// A reading that is measured has noise; one at the end of the range repeats. So the largest reading of a signal counts
/// as the end of its range when it stands for at least three samples in a row, and for more than three times as many as
/// 19 of 20 other readings repeat: of those beyond a fifth of it, or of all where these are fewer than ten. Empty also
/// where the others are fewer than ten: a made-up log without noise.
[[nodiscard]] std::optional<RangeEnd> range_end(const Signal& signal, Side side);

}  // namespace fantail::listen
