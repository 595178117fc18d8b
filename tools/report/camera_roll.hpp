// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "flight/flight.hpp"

namespace fantail::report {

/// How far the roll that a camera sees and the roll angle, which is the integral of a body rate, came apart since
/// launch detection: the rocket cones. Of a simulated flight in six degrees of freedom.
struct CameraRoll {
  double largest_rad = 0.0;  ///< of the camera's less the true roll angle, with its sign
  double at_end_rad = 0.0;   ///< likewise, at the end of control

  friend bool operator==(const CameraRoll&, const CameraRoll&) = default;
};

/// Row by row.
class CameraRollWatch {
 public:
  /// Each row, in order. Those from launch detection to the end of control count.
  void add(const flight::Row& row);

  [[nodiscard]] const std::optional<CameraRoll>& found() const { return found_; }

 private:
  double zero_rad_ = 0.0;
  std::optional<CameraRoll> found_{};
};

}  // namespace fantail::report
