// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plot/chart.hpp"
#include "plot/drawing.hpp"
#include "plot/label_places.hpp"

namespace fantail::plot {

constexpr double top_label_row = 15.0;

/// The labels of stripes and upright levels, in rows above the frame. One without room is left out; its text still
/// shows under a mouse.
class TopLabels {
 public:
  /// Only the drawing's x is used.
  TopLabels(const Chart& chart, const Drawing& drawing);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  void draw(Drawing& drawing) const;

 private:
  struct Label {
    double middle;
    std::string text;
    std::size_t row = 0;  ///< counted upwards from the frame
  };

  std::vector<Label> labels_{};
  std::size_t rows_ = 0;
};

void draw_stripes(Drawing& drawing, const Chart& chart);
void draw_levels(Drawing& drawing, const Chart& chart);
/// Of the level ones; after the curves, which they keep away from.
void label_levels(Drawing& drawing, LabelPlaces& places, const Chart& chart);

}  // namespace fantail::plot
