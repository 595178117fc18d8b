// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace fantail::plot {

/// A value over two axes as coloured cells, with a key. NaN cells stay empty.
struct HeatMap {
  struct Spot {
    double x;
    double y;
    std::string label;
  };
  std::string label{};
  std::string x_label{};
  std::string y_label{};
  std::string value_label{};    ///< with its unit
  std::vector<double> x{};      ///< increasing, evenly spaced
  std::vector<double> y{};      ///< likewise
  std::vector<double> value{};  ///< value[j * x.size() + i] belongs to x[i], y[j]
  std::vector<Spot> spots{};    ///< the winner, the print's, ...
  bool logarithmic = true;      ///< of the colour, over at most three decades, so that a narrow valley shows
  double width = 880.0;
  double height = 380.0;
};

[[nodiscard]] std::string svg(const HeatMap& map);

}  // namespace fantail::plot
