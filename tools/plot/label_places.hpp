// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace fantail::plot {

/// In the drawing's own units, y downwards.
struct Pixel {
  double x;
  double y;
};
struct Box {
  double left;
  double top;
  double right;
  double bottom;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
};

/// Finds places for labels that cover neither each other nor, if possible, what is drawn.
class LabelPlaces {
 public:
  explicit LabelPlaces(Box inside) : inside_{inside} {}

  void keep_free(Box box) { taken_.push_back(box); }
  void avoid(Pixel point) { drawn_.push_back(point); }

  /// The candidate that covers the least, the first of equals, which is then taken. Empty when none lies inside and
  /// free.
  std::optional<Box> take(std::span<const Box> candidates);

 private:
  Box inside_;
  std::vector<Box> taken_{};
  std::vector<Pixel> drawn_{};
};

}  // namespace fantail::plot
