// SPDX-License-Identifier: MIT
#include "bench/chart.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/core.h>

#include "report/decimate.hpp"
#include "report/escape.hpp"
#include "report/numbers.hpp"

namespace fantail::bench {
namespace {

using report::brief;
using report::with_minus;

constexpr double left = 36.0;
constexpr double margin_right = 6.0;
constexpr double margin_bottom = 20.0;

struct Range {
  double low;
  double high;
};

// 1, 2 or 5 times a power of ten, so that about `wanted` steps fit.
double tick_step(Range range, double wanted) {
  const double raw = (range.high - range.low) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw * 0.999) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

class Drawing {
 public:
  explicit Drawing(const Chart& chart)
      : chart_{chart},
        right_{chart.width - margin_right},
        top_{chart.bands.empty() ? 6.0 : 18.0},  // the bands' labels stand above
        bottom_{chart.height - margin_bottom} {
    time_ = {chart.time.front(), std::max(chart.time.back(), chart.time.front() + 1e-6)};
    angle_ = {-1.0, 1.0};
    for (const auto* line : {&chart.command_deg, &chart.encoder_deg}) {
      for (const double value : *line) {
        if (std::isfinite(value)) {
          angle_ = {std::min(angle_.low, value), std::max(angle_.high, value)};
        }
      }
    }
    for (const Chart::Level& level : chart.levels) {
      angle_ = {std::min(angle_.low, level.angle_deg), std::max(angle_.high, level.angle_deg)};
    }
    const double margin = 0.09 * (angle_.high - angle_.low);
    angle_ = {angle_.low - margin, angle_.high + margin};
  }

  std::string draw() {
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", chart_.width,
        chart_.height, report::escape_html(chart_.label));
    bands();
    grid();
    levels();
    const std::vector<std::size_t> kept =
        report::keep_extremes(std::vector{chart_.command_deg, chart_.encoder_deg}, chart_.buckets);
    curve("command", chart_.command_deg, kept);
    curve("encoder", chart_.encoder_deg, kept);
    return out_ + "</svg>";
  }

 private:
  template <typename... T>
  void add(fmt::format_string<T...> format, T&&... values) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<T>(values)...);
  }
  [[nodiscard]] double x(double time) const {
    return left + (right_ - left) * (std::clamp(time, time_.low, time_.high) - time_.low) / (time_.high - time_.low);
  }
  [[nodiscard]] double y(double angle_deg) const {
    return bottom_ - (bottom_ - top_) * (angle_deg - angle_.low) / (angle_.high - angle_.low);
  }

  void bands() {
    double taken = left;
    for (const Chart::Band& band : chart_.bands) {
      const double from = x(band.begin);
      const double to = x(band.end);
      add("<rect class=\"band\" x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", from, top_, to - from,
          bottom_ - top_);
      const double half = 2.8 * static_cast<double>(band.label.size());
      const double middle = std::clamp(0.5 * (from + to), left + half, right_ - half);
      if (!band.label.empty() && middle - half >= taken) {
        add("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>", middle, top_ - 6,
            report::escape_html(band.label));
        taken = middle + half + 4.0;
      }
    }
  }

  void grid() {
    const double time_step = tick_step(time_, 6.0);
    for (auto i = std::lround(std::ceil(time_.low / time_step)); static_cast<double>(i) * time_step <= time_.high;
         ++i) {
      const double time = static_cast<double>(i) * time_step;
      const bool last = static_cast<double>(i + 1) * time_step > time_.high;
      add("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"{}\">{}{}</text>", x(time), bottom_ + 14,
          x(time) > right_ - 14.0 ? "end" : "middle", with_minus(brief(time, 3)),
          last ? " " + chart_.time_unit : std::string{});
    }
    const double angle_step = tick_step(angle_, 5.0);
    for (auto i = std::lround(std::ceil(angle_.low / angle_step)); static_cast<double>(i) * angle_step <= angle_.high;
         ++i) {
      const double angle_deg = static_cast<double>(i) * angle_step;
      add("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/><text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}&#176;</text>",
          left, y(angle_deg), right_, left - 5, y(angle_deg) + 4, with_minus(brief(angle_deg, 3)));
    }
  }

  void levels() {
    for (const Chart::Level& level : chart_.levels) {
      add("<path class=\"level\" d=\"M{} {:.1f}H{}\"/>", left, y(level.angle_deg), right_);
      if (!level.label.empty()) {
        const double above = level.angle_deg >= 0.0 ? -4.0 : 12.0;
        add("<text class=\"level\" x=\"{}\" y=\"{:.1f}\">{}</text>", left + 3, y(level.angle_deg) + above,
            report::escape_html(level.label));
      }
    }
  }

  // A point between two others at the same height is left out: most of a command is such points.
  void curve(std::string_view line, const std::vector<double>& values, const std::vector<std::size_t>& kept) {
    std::string path;
    std::string waiting;
    std::string height;
    bool pen_down = false;
    for (const std::size_t i : kept) {
      if (!std::isfinite(values[i])) {
        path += waiting;
        waiting.clear();
        pen_down = false;
        continue;
      }
      std::string here = fmt::format("{:.1f}", y(values[i]));
      std::string point = fmt::format("{}{:.1f} {}", pen_down ? 'L' : 'M', x(chart_.time[i]), here);
      if (pen_down && here == height) {
        waiting = std::move(point);
      } else {
        path += waiting + point;
        waiting.clear();
      }
      height = std::move(here);
      pen_down = true;
    }
    path += waiting;
    if (!path.empty()) {
      add("<path class=\"{}\" d=\"{}\"/>", line, path);
    }
  }

  const Chart& chart_;
  double right_;
  double top_;
  double bottom_;
  Range time_{};
  Range angle_{};
  std::string out_;
};

}  // namespace

std::string chart_svg(const Chart& chart) { return chart.time.empty() ? std::string{} : Drawing{chart}.draw(); }

}  // namespace fantail::bench
