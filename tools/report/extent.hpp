// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "flight/flight.hpp"

namespace fantail::report {

/// Between two rows that follow each other, and so much farther apart than the others that nobody knows what was
/// between.
struct Hole {
  double from_s = 0.0;
  double to_s = 0.0;

  friend bool operator==(const Hole&, const Hole&) = default;
};

/// When something is known: from the first to the last row that has it, but for the holes.
struct Extent {
  double begin_s = 0.0;
  double end_s = 0.0;
  double usual_step_s = 0.0;
  std::vector<Hole> holes{};

  /// Near enough to a row that has it.
  [[nodiscard]] bool covers(double time_s) const;
  /// So seldom that a roll angle may have been anywhere in between.
  [[nodiscard]] bool is_thin() const;

  friend bool operator==(const Extent&, const Extent&) = default;
};

/// Row by row.
class RunningExtent {
 public:
  /// Between rows that are farther apart than this everything may have happened, however many rows a second there are.
  static constexpr double longest_step_s = 0.3;
  /// Within this, nothing has, however few.
  static constexpr double shortest_hole_s = 0.1;

  /// Each row that has it, in order.
  void add(double time_s);

  /// Of the rows up to now, on another clock.
  [[nodiscard]] Extent extent(const flight::Clock& clock) const;
  /// Likewise, where all rows, and not only those that have it, are usually so far apart.
  [[nodiscard]] Extent extent(const flight::Clock& clock, double usual_step_s) const;

 private:
  std::size_t rows_ = 0;
  double first_s_ = 0.0;
  double last_s_ = 0.0;
  std::vector<Hole> steps_{};  ///< that may be holes
};

}  // namespace fantail::report
