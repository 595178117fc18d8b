// SPDX-License-Identifier: MIT
#include "report/card.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "page/axis.hpp"
#include "page/page.hpp"
#include "page/thinning.hpp"
#include "report/card_text.hpp"
#include "report/chart_drawer.hpp"
#include "report/html.hpp"
#include "report/roll_truth.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

constexpr double left = 64.0;
constexpr double right = 1136.0;

struct Curve {
  std::vector<double> time_s{};
  std::vector<double> roll_deg{};
};

std::string text_at(double x, double y, double size, std::string_view style, std::string_view words) {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" font-size=\"{:.0f}\" {}>{}</text>\n", x, y, size, style,
                     page::printed(words));
}

std::string_view colour_of(page::Tone tone) {
  switch (tone) {
    case page::Tone::good: return "#0b8457";
    case page::Tone::bad: return "#c22f2f";
    default: return "#a16207";
  }
}

class Plot {
 public:
  /// A full turn and its parts in degrees are no even numbers, so a roll of half a turn or more is in turns.
  Plot(double top, page::Range time_s, page::Range roll_deg)
      : top_{top},
        time_s_{page::drawable(time_s)},
        in_turns_{roll_deg.high - roll_deg.low >= 180.0},
        roll_{page::drawable({shown(roll_deg.low), shown(roll_deg.high)})} {}

  [[nodiscard]] std::string_view unit() const { return in_turns_ ? "turns" : "degrees"; }

  [[nodiscard]] std::string axes() const {
    std::string out;
    for (const page::Tick& tick : page::even_ticks(roll_, 4.0)) {
      out += fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#d9dee4\"/>\n", left, y(tick.value), right - 60.0);
      out += text_at(right - 50.0, y(tick.value) + 6.0, 18.0, "fill=\"#586069\"", tick.text);
    }
    for (const page::Tick& tick : page::even_ticks(time_s_, 8.0)) {
      out += text_at(x(tick.value), bottom_ + 26.0, 18.0, "fill=\"#586069\" text-anchor=\"middle\"", tick.text + " s");
    }
    return out;
  }

  [[nodiscard]] std::string line(const Curve& curve, std::string_view style) const {
    std::string path;
    bool pen_down = false;
    const std::vector<std::vector<double>> columns{curve.roll_deg};
    const std::vector<std::size_t> gaps = page::gaps(curve.time_s);  // over which nobody knows how it turned
    auto gap = gaps.begin();
    for (const std::size_t i : page::keep_extremes(columns, 500)) {
      const bool known = std::isfinite(curve.roll_deg[i]);
      for (; gap != gaps.end() && *gap <= i; ++gap) {
        pen_down = false;
      }
      if (known) {
        path += fmt::format("{}{:.1f} {:.1f}", pen_down ? 'L' : 'M', x(curve.time_s[i]), y(shown(curve.roll_deg[i])));
      }
      pen_down = known;
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", path, style);
  }

 private:
  [[nodiscard]] double x(double time_s) const {
    return left + (right - 60.0 - left) * (time_s - time_s_.low) / (time_s_.high - time_s_.low);
  }
  [[nodiscard]] double y(double roll) const {
    return bottom_ - (bottom_ - top_) * (roll - roll_.low) / (roll_.high - roll_.low);
  }
  [[nodiscard]] double shown(double degrees) const { return in_turns_ ? degrees / 360.0 : degrees; }

  double top_;
  double bottom_ = 536.0;
  page::Range time_s_;
  bool in_turns_;
  page::Range roll_;
};

std::string roll_plot(const flight::Flight& flight, double top) {
  const PlotWindow window = plot_window(flight);
  Curve flown;
  Curve free;
  std::optional<page::Range> roll_deg_range;
  const auto add = [&](Curve& curve, double time_s, double roll_deg) {
    if (time_s >= window.begin_s && time_s <= window.end_s) {
      curve.time_s.push_back(time_s);
      curve.roll_deg.push_back(roll_deg);
      page::include(roll_deg_range, roll_deg);
    }
  };
  const bool is_true = knows_true_roll(flight.rows);
  for (const flight::Row& row : flight.rows) {
    add(flown, row.time_s, roll_deg(row, is_true));
  }
  for (const flight::FreeRollPoint& point : flight.without_control) {
    add(free, point.time_s, text::degrees(point.true_roll_angle_rad));
  }
  if (!roll_deg_range) {
    return {};
  }
  // Less than a tenth of a turn is not to look like a roll.
  page::include(roll_deg_range, roll_deg_range->low + 36.0);
  const Plot plot{top + 16.0, {window.begin_s, window.end_s}, *roll_deg_range};
  std::string out = plot.axes();
  out += text_at(left, top, 20.0, "fill=\"#0f5fb5\" font-weight=\"bold\"",
                 fmt::format("\u2014 roll angle in {}, as flown", plot.unit()));
  if (!free.time_s.empty()) {
    out += text_at(left + 420.0, top, 20.0, "fill=\"#586069\"", "\u2013 \u2013 without control");
    out += plot.line(free, "stroke=\"#7b8691\" stroke-width=\"4\" stroke-dasharray=\"12 8\"");
  }
  return out + plot.line(flown, "stroke=\"#0f5fb5\" stroke-width=\"5\"");
}

std::array<std::string, 2> figure_rows(const flight::Flight& flight, const Figures& f) {
  std::array<std::string, 2> rows;
  const auto add = [](std::string& row, const std::optional<double>& value, int decimals, std::string_view words) {
    if (value) {
      row += row.empty() ? "" : " \u00b7 ";
      row += fmt::format(fmt::runtime(words), text::fixed(*value, decimals));
    }
  };
  add(rows[0], f.apogee_m, 0, "apogee {} m");
  add(rows[0], f.max_speed_m_s, 0,
      flight.tunnel         ? "wind {} m/s"
      : flight.path.empty() ? "top speed {} m/s"
                            : "top speed {} m/s over ground");
  add(rows[0], f.control_time_s, 1, "{} s under control");
  const flight::Events& e = flight.events;
  const std::string when =
      e.control_start_s && e.control_end_s
          ? fmt::format(", {} s to {} s", text::fixed(*e.control_start_s, 1), text::fixed(*e.control_end_s, 1))
          : "";
  add(rows[1], f.roll_turns, 2, "turned by {} turns under control" + when);
  add(rows[1], f.roll_turns_without_control, 2, "without control by {} turns");
  return rows;
}

/// A long verdict in smaller letters, because none of it is to be missed.
std::string verdict_lines(std::string_view verdict, double& y) {
  constexpr double most_height = 160.0;
  constexpr double line_height = 1.29;
  constexpr double smallest = 10.0;
  double size = 24.0;
  const auto lines_at = [&] { return in_lines(verdict, {size}, right - left, 12); };
  std::vector<std::string> lines = lines_at();
  while (size > smallest && size * line_height * static_cast<double>(lines.size()) > most_height) {
    size -= 1.0;
    lines = lines_at();
  }
  std::string out;
  for (const std::string& line : lines) {
    out += text_at(left, y, size, "fill=\"#1f2933\"", line);
    y += size * line_height;
  }
  return out;
}

}  // namespace

std::string card_svg(const flight::Flight& flight, const Figures& figures, const Verdict& verdict) {
  const std::string_view colour = colour_of(tone(verdict));
  std::string out =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1200\" height=\"630\" viewBox=\"0 0 1200 630\" "
      "font-family=\"DejaVu Sans, sans-serif\">\n<rect width=\"1200\" height=\"630\" fill=\"#ffffff\"/>\n";
  out += fmt::format("<rect width=\"16\" height=\"630\" fill=\"{}\"/>\n", colour);
  const auto line = [&out](double y, const Letters& letters, std::string_view fill, std::string_view words) {
    out +=
        text_at(left, y, letters.size, fmt::format("fill=\"{}\"{}", fill, letters.bold ? " font-weight=\"bold\"" : ""),
                in_lines(words, letters, right - left, 1).front());
  };
  line(62.0, {22.0}, "#586069", "Fantail flight report" + (flight.vehicle.empty() ? "" : " \u00b7 " + flight.vehicle));
  line(118.0, {50.0, true}, "#1f2933", flight.scenario);
  line(168.0, {30.0, true}, colour, display_name(verdict.outcome));
  double y = 206.0;
  out += verdict_lines(verdict.text, y);
  y += 6.0;
  for (const std::string& words : figure_rows(flight, figures)) {
    out += text_at(left, y, 20.0, "fill=\"#586069\"", words);
    y += 28.0;
  }
  out += roll_plot(flight, std::max(y + 10.0, 366.0));
  std::string origin = flight.seed ? fmt::format("Simulated, seed {}.", *flight.seed) : "From a log.";
  if (!flight.changes.empty()) {
    origin += fmt::format(" Changed on the command line: {}.", fmt::join(flight.changes, ", "));
  }
  y = 592.0;
  for (const std::string& words : in_lines(origin, {16.0}, right - left, 2)) {
    out += text_at(left, y, 16.0, "fill=\"#586069\"", words);
    y += 22.0;
  }
  return out + "</svg>\n";
}

}  // namespace fantail::report
