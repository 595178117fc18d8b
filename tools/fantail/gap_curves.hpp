// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plot/chart.hpp"

namespace fantail::tool {

/// Curves over one clock. Where samples were left out they have gaps: a point that is no number stands between.
class GapCurves {
 public:
  explicit GapCurves(const std::vector<double>& time_s);

  /// `scale` turns the values into what is drawn.
  [[nodiscard]] plot::Series curve(std::string name, plot::Role role, const std::vector<double>& values,
                                   double scale) const;
  [[nodiscard]] plot::Series in_degrees(std::string name, plot::Role role, const std::vector<double>& values_rad) const;

 private:
  std::vector<double> time_s_{};
  std::vector<std::size_t> gaps_{};
};

}  // namespace fantail::tool
