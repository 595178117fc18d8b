// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "plot/axis.hpp"
#include "plot/label_places.hpp"

namespace fantail::plot {

/// The text of one SVG with a plot in it: where its frame lies and how values become places.
class Drawing {
 public:
  void place(Box frame, Range x, Range y) {
    frame_ = frame;
    x_ = x;
    y_ = y;
  }

  [[nodiscard]] const Box& frame() const { return frame_; }
  [[nodiscard]] double x(double value) const { return far(frame_.left + frame_.width() * part(value, x_)); }
  [[nodiscard]] double y(double value) const { return far(frame_.bottom - frame_.height() * part(value, y_)); }
  [[nodiscard]] Range x_range() const { return x_; }
  [[nodiscard]] Range y_range() const { return y_; }

  template <typename... T>
  void add(fmt::format_string<T...> format, T&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<T>(values)...);
  }

  void begin(std::string_view kind, std::string_view label, double width, double height);
  /// Texts below the frame, and the grid's upright lines when asked for; a text without room is left out.
  void x_axis(const std::vector<Tick>& ticks, std::string_view label, bool grid);
  void y_axis(const std::vector<Tick>& ticks, bool grid);
  /// In the middle of the frame, instead of what is missing.
  void remark(std::string_view text);
  [[nodiscard]] std::string end() { return std::exchange(text_, {}) + "</svg>"; }

 private:
  static double part(double value, Range range) { return (value - range.low) / (range.high - range.low); }
  // Browsers lose count at coordinates of a million.
  static double far(double place) { return std::clamp(place, -2e5, 2e5); }

  Box frame_{};
  Range x_{0.0, 1.0};
  Range y_{0.0, 1.0};
  std::string text_{};
};

constexpr double tick_row = 17.0;   ///< below the frame
constexpr double label_row = 18.0;  ///< below that
/// Room that the texts of a y axis need left of the frame.
[[nodiscard]] double tick_column(const std::vector<Tick>& ticks);
/// Room right of the frame for half the text of the last tick.
[[nodiscard]] double end_margin(const std::vector<Tick>& ticks);

}  // namespace fantail::plot
