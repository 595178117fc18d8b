// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace fantail::page {

struct Range {
  double low;
  double high;
};

/// Grows to hold the value; what is not finite changes nothing.
void include(std::optional<Range>& range, double value);

/// Fit to be drawn: low below high by more than rounding can hide, whatever came in.
[[nodiscard]] Range drawable(Range range);

enum class Scale : std::uint8_t { linear, logarithmic };

/// Fit for this scale: a logarithmic one keeps three decades below its high end where the low end is not above zero.
[[nodiscard]] Range drawable(Range range, Scale scale);

/// Where a value lies in a range: 0 at its low end, 1 at its high end. On a logarithmic scale both ends are above zero,
/// and what is not lies far below the range.
[[nodiscard]] double part_of(double value, Range range, Scale scale);

struct Tick {
  double value;
  std::string text;
};

/// 1, 2 or 5 times a power of ten apart, so that their number is near `wanted`.
[[nodiscard]] std::vector<Tick> even_ticks(Range range, double wanted);
/// 1, 2 and 5 times the powers of ten, or the powers alone when that is too many; even ones when the range is narrow.
[[nodiscard]] std::vector<Tick> decade_ticks(Range range, double wanted);
/// At these values and nowhere else, each once.
[[nodiscard]] std::vector<Tick> ticks_at(std::span<const double> values, Range range);

/// Which samples of several series on one clock to draw: of each of `buckets` equal stretches the first sample and the
/// smallest and largest of every series, and the last sample of all. No peak is lost, however short; NaN is skipped.
/// Increasing indices without repeats. All series have the same length.
[[nodiscard]] std::vector<std::size_t> keep_extremes(std::span<const std::vector<double>> series, std::size_t buckets);

/// The samples before which others are missing: each comes five times later than is usual here. Increasing.
[[nodiscard]] std::vector<std::size_t> gaps(std::span<const double> x);

/// How wide the text stands in the plot's own units, rather too much than too little: nobody knows the reader's
/// font.
[[nodiscard]] double text_width(std::string_view text);

/// As much of the text as fits, with an ellipsis when that is not all.
[[nodiscard]] std::string shortened(std::string_view text, double width);

/// In the plot's own units, y downwards.
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
class LabelPlacer {
 public:
  explicit LabelPlacer(Box inside) : inside_{inside} {}

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

/// The text of one SVG with a plot in it: where its frame lies and how values become places.
class SvgPlot {
 public:
  void place(Box frame, Range x, Range y, Scale x_scale = Scale::linear) {
    frame_ = frame;
    x_ = x;
    y_ = y;
    x_scale_ = x_scale;
  }

  [[nodiscard]] const Box& frame() const { return frame_; }
  [[nodiscard]] double x(double value) const {
    return clamped(frame_.left + frame_.width() * part_of(value, x_, x_scale_));
  }
  [[nodiscard]] double y(double value) const {
    return clamped(frame_.bottom - frame_.height() * part_of(value, y_, Scale::linear));
  }
  [[nodiscard]] Range x_range() const { return x_; }
  [[nodiscard]] Range y_range() const { return y_; }

  template <typename... T>
  void add(fmt::format_string<T...> format, T&&... values) {
    text_ += fmt::format(format, std::forward<T>(values)...);
  }

  /// `more`: further attributes, with a space before each.
  void begin(std::string_view kind, std::string_view label, double width, double height, std::string_view more = {});
  void outline(std::string_view kind);
  /// Texts below the frame; one without room is left out. A logarithmic scale has a line across the frame for each.
  void x_axis(const std::vector<Tick>& ticks, std::string_view label);
  void y_axis(const std::vector<Tick>& ticks, bool grid);
  /// In the middle of the frame, instead of what is missing.
  void remark(std::string_view text);
  [[nodiscard]] std::string end() { return std::exchange(text_, {}) + "</svg>"; }

 private:
  // Browsers lose count at coordinates of a million.
  static double clamped(double place) { return std::clamp(place, -2e5, 2e5); }

  Box frame_{};
  Range x_{0.0, 1.0};
  Range y_{0.0, 1.0};
  Scale x_scale_ = Scale::linear;
  std::string text_{};
};

constexpr double tick_row = 17.0;   ///< below the frame
constexpr double label_row = 18.0;  ///< below that
/// Room that the texts of a y axis need left of the frame.
[[nodiscard]] double tick_column(const std::vector<Tick>& ticks);
/// Room right of the frame for half the text of the last tick.
[[nodiscard]] double end_margin(const std::vector<Tick>& ticks);

}  // namespace fantail::page
