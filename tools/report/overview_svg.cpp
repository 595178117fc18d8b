// SPDX-License-Identifier: MIT
#include "report/overview_svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <string_view>

#include <fmt/core.h>

#include "report/decimate.hpp"
#include "report/escape.hpp"
#include "report/numbers.hpp"
#include "report/page_assets.hpp"
#include "report/timeline.hpp"

namespace fantail::report {
namespace {

constexpr double width = 860.0;
constexpr double left = 56.0;
constexpr double right = 848.0;
constexpr double top = 78.0;
constexpr double bottom = 346.0;
constexpr double label_width_per_letter = 6.6;  // of the 12 px labels, on the safe side
constexpr int label_rows = 4;

enum Line : std::uint8_t { reference, settle, truth, estimate, line_count };
constexpr std::array<std::string_view, line_count> line_class{"reference", "settle", "truth", "estimate"};
constexpr std::array<std::string_view, line_count> line_name{"reference R", "settles at R + u_d/kp", "true",
                                                             "estimate"};

struct Range {
  double low;
  double high;
};

std::vector<double> multiples_within(Range range, double step) {
  std::vector<double> values;
  for (auto i = std::lround(std::ceil(range.low / step)); static_cast<double>(i) * step <= range.high; ++i) {
    values.push_back(static_cast<double>(i) * step);
  }
  return values;
}

// 1, 2 or 5 times a power of ten, so that about `wanted` steps fit.
double tick_step(Range range, int wanted) {
  const double raw = (range.high - range.low) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

class Picture {
 public:
  Picture(const Flight& flight, std::span<const Row> rows) : flight_{flight}, rows_{rows} {
    read_lines();
    time_ = {rows.front().time_s, std::max(rows.back().time_s, rows.front().time_s + 1e-3)};
    angle_ = {-1.0, 1.0};
    for (const auto& line : lines_) {
      for (const double value : line) {
        if (std::isfinite(value)) {
          angle_ = {std::min(angle_.low, value), std::max(angle_.high, value)};
        }
      }
    }
    const double margin = 0.06 * (angle_.high - angle_.low);
    angle_ = {angle_.low - margin, angle_.high + margin};
  }

  std::string draw() {
    add("<svg class=\"overview\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} 410\" role=\"img\" "
        "aria-label=\"Roll angle over time\"><style>{}</style><rect class=\"paper\" width=\"{}\" height=\"410\"/>",
        width, overview_css, width);
    bands();
    grid();
    curves();
    marks();
    legend();
    return out_ + "</svg>";
  }

 private:
  template <typename... T>
  void add(fmt::format_string<T...> format, T&&... values) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<T>(values)...);
  }
  [[nodiscard]] double x(double time_s) const {
    return left + (right - left) * (std::clamp(time_s, time_.low, time_.high) - time_.low) / (time_.high - time_.low);
  }
  [[nodiscard]] double y(double angle_deg) const {
    return bottom - (bottom - top) * (angle_deg - angle_.low) / (angle_.high - angle_.low);
  }

  void read_lines() {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    for (const Row& row : rows_) {
      const bool control = !flight_.known.phase || row.phase == core::Phase::controlling;
      const std::optional<double> point = settle_point_rad(row, flight_);
      lines_[reference].push_back(control ? degrees(row.reference_rad) : gap);
      lines_[settle].push_back(control && point ? degrees(*point) : gap);
      lines_[truth].push_back(row.truth ? degrees(row.truth->roll_angle_rad) : gap);
      lines_[estimate].push_back(degrees(row.roll_angle_rad));
    }
  }

  void bands() {
    if (!flight_.known.phase) {
      return;
    }
    for (const PhaseBand& band : phase_bands(flight_)) {
      if (const double w = x(band.end_s) - x(band.begin_s); w > 0.0) {
        add("<rect class=\"{}\" x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\"/>", core::name(band.phase),
            x(band.begin_s), top, w, bottom - top);
      }
    }
  }

  void grid() {
    const double time_step = tick_step(time_, 9);
    for (const double time_s : multiples_within(time_, time_step)) {
      add("<text class=\"tick\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>", x(time_s), bottom + 18,
          with_minus(brief(time_s, 3)));
    }
    add("<text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"end\">seconds</text>", right, bottom + 34);
    const double angle_step = tick_step(angle_, 5);
    for (const double angle_deg : multiples_within(angle_, angle_step)) {
      const double at = y(angle_deg);
      add("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/><text class=\"tick\" x=\"{}\" y=\"{:.1f}\" "
          "text-anchor=\"end\">{}&#176;</text>",
          left, at, right, left - 7, at + 4, with_minus(brief(angle_deg, 3)));
    }
  }

  void curves() {
    const std::vector<std::size_t> kept = keep_extremes(lines_, 300);
    const std::vector<std::size_t> missing_after = gaps(rows_);
    for (std::size_t line = 0; line < line_count; ++line) {
      std::string path;
      bool pen_down = false;
      auto gap = missing_after.begin();
      for (const std::size_t i : kept) {
        for (; gap != missing_after.end() && *gap < i; ++gap) {
          pen_down = false;
        }
        const double value = lines_[line][i];
        if (!std::isfinite(value)) {
          pen_down = false;
          continue;
        }
        // A stepped reference stays a step between two samples that were kept far apart.
        if (pen_down && (line == reference || line == settle)) {
          path += fmt::format("H{:.1f}", x(rows_[i].time_s));
        }
        path += fmt::format("{}{:.1f} {:.1f}", pen_down ? 'L' : 'M', x(rows_[i].time_s), y(value));
        pen_down = true;
      }
      if (!path.empty()) {
        add("<path class=\"{}\" d=\"{}\"/>", line_class[line], path);
        drawn_[line] = true;
      }
    }
  }

  void marks() {
    std::array<double, label_rows> taken{};
    for (const EventMark& mark : event_marks(flight_)) {
      if (mark.time_s < time_.low || mark.time_s > time_.high) {
        continue;
      }
      const double at = x(mark.time_s);
      const double needed = label_width_per_letter * static_cast<double>(mark.label.size()) + 8.0;
      const auto row = std::ranges::find_if(taken, [at](double end) { return end <= at; });
      if (mark.label.empty() || row == taken.end()) {
        add("<path class=\"event\" d=\"M{:.1f} {}V{}\"/>", at, top, bottom);
        continue;
      }
      const double line_y = 14.0 + 17.0 * static_cast<double>(row - taken.begin());
      const bool turned = at + needed > right;  // at the right edge the label stands left of its line
      *row = at + needed;
      add("<path class=\"event\" d=\"M{:.1f} {}V{}\"/><text class=\"event\" x=\"{:.1f}\" y=\"{}\"{}>{}</text>", at,
          line_y - 9.0, bottom, turned ? at - 4.0 : at + 4.0, line_y, turned ? " text-anchor=\"end\"" : "",
          escape_html(mark.label));
    }
  }

  void legend() {
    double at = left;
    for (std::size_t line = line_count; line-- > 0;) {
      if (drawn_[line]) {
        add("<path class=\"{}\" d=\"M{} 394h22\"/><text class=\"tick\" x=\"{}\" y=\"398\">{}</text>", line_class[line],
            at, at + 28.0, line_name[line]);
        at += 28.0 + 7.0 * static_cast<double>(line_name[line].size()) + 22.0;
      }
    }
  }

  const Flight& flight_;
  std::span<const Row> rows_;
  std::vector<std::vector<double>> lines_ = std::vector<std::vector<double>>(line_count);
  std::array<bool, line_count> drawn_{};
  Range time_{};
  Range angle_{};
  std::string out_;
};

}  // namespace

std::string overview_svg(const Flight& flight) {
  const Window window = plot_window(flight);
  const std::span<const Row> rows = rows_between(flight, window.begin_s, window.end_s);
  return rows.empty() ? std::string{} : Picture{flight, rows}.draw();
}

}  // namespace fantail::report
