// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fantail::page {

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

struct Colour {
  std::uint8_t red;
  std::uint8_t green;
  std::uint8_t blue;

  bool operator==(const Colour&) const = default;
};

/// From dark violet at 0 over green to bright yellow at 1. Lightness grows evenly, so that the order can be read
/// without colour vision, in grey print, on white and on black. Values outside 0..1 get the end colours.
[[nodiscard]] Colour colour_at(double part);

}  // namespace fantail::page
