// SPDX-License-Identifier: MIT
#include "report/card.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "page/axis.hpp"
#include "page/page.hpp"
#include "page/thinning.hpp"
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
  std::vector<double> turns{};
};

constexpr double in_turns(double degrees) { return degrees / 360.0; }

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

/// A word wider than a line is cut there; what three lines do not hold ends with an ellipsis.
std::vector<std::string> in_lines(std::string_view words, std::size_t width, std::size_t most) {
  std::vector<std::string> lines{""};
  while (!words.empty()) {
    const std::size_t space = words.find(' ');
    const std::string_view word = words.substr(0, std::min(space, width));
    words.remove_prefix(std::min(words.size(), space == word.size() ? space + 1 : word.size()));
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width) {
      if (lines.size() == most) {
        lines.back() += " \u2026";
        return lines;
      }
      lines.emplace_back();
    }
    lines.back() += lines.back().empty() ? "" : " ";
    lines.back() += word;
  }
  return lines;
}

class Plot {
 public:
  Plot(page::Range time_s, page::Range turns) : time_s_{page::drawable(time_s)}, turns_{page::drawable(turns)} {}

  [[nodiscard]] std::string axes() const {
    std::string out;
    for (const page::Tick& tick : page::even_ticks(turns_, 4.0)) {
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
    const std::vector<std::vector<double>> columns{curve.turns};
    for (const std::size_t i : page::keep_extremes(columns, 500)) {
      const bool known = std::isfinite(curve.turns[i]);
      if (known) {
        path += fmt::format("{}{:.1f} {:.1f}", pen_down ? 'L' : 'M', x(curve.time_s[i]), y(curve.turns[i]));
      }
      pen_down = known;
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", path, style);
  }

 private:
  [[nodiscard]] double x(double time_s) const {
    return left + (right - 60.0 - left) * (time_s - time_s_.low) / (time_s_.high - time_s_.low);
  }
  [[nodiscard]] double y(double turns) const {
    return bottom_ - (bottom_ - top_) * (turns - turns_.low) / (turns_.high - turns_.low);
  }

  double top_ = 382.0;
  double bottom_ = 556.0;
  page::Range time_s_;
  page::Range turns_;
};

std::string roll_plot(const flight::Flight& flight) {
  const PlotWindow window = plot_window(flight);
  Curve flown;
  Curve free;
  std::optional<page::Range> turns;
  const bool is_true = knows_true_roll(flight.rows);
  for (const flight::Row& row : flight.rows) {
    if (row.time_s >= window.begin_s && row.time_s <= window.end_s) {
      flown.time_s.push_back(row.time_s);
      flown.turns.push_back(in_turns(roll_deg(row, is_true)));
      page::include(turns, flown.turns.back());
    }
  }
  for (const flight::FreeRollPoint& point : flight.without_control) {
    if (point.time_s >= window.begin_s && point.time_s <= window.end_s) {
      free.time_s.push_back(point.time_s);
      free.turns.push_back(in_turns(text::degrees(point.true_roll_angle_rad)));
      page::include(turns, free.turns.back());
    }
  }
  if (!turns) {
    return {};
  }
  // Less than a tenth of a turn is not to look like a roll.
  page::include(turns, turns->low + 0.1);
  const Plot plot{{window.begin_s, window.end_s}, *turns};
  std::string out = plot.axes();
  out += text_at(left, 366.0, 20.0, "fill=\"#0f5fb5\" font-weight=\"bold\"", "\u2014 turns, as flown");
  if (!free.time_s.empty()) {
    out += text_at(left + 250.0, 366.0, 20.0, "fill=\"#586069\"", "\u2013 \u2013 without control");
    out += plot.line(free, "stroke=\"#7b8691\" stroke-width=\"4\" stroke-dasharray=\"12 8\"");
  }
  return out + plot.line(flown, "stroke=\"#0f5fb5\" stroke-width=\"5\"");
}

std::string figure_row(const flight::Flight& flight, const Figures& f) {
  std::vector<std::string> all;
  const auto add = [&all](const std::optional<double>& value, int decimals, std::string_view words) {
    if (value) {
      all.push_back(fmt::format(fmt::runtime(words), text::fixed(*value, decimals)));
    }
  };
  add(f.apogee_m, 0, "apogee {} m");
  add(f.max_speed_m_s, 0, flight.tunnel ? "wind {} m/s" : "top speed {} m/s");
  add(f.control_time_s, 1, "{} s under control");
  add(f.roll_turns, 2, "turned by {}");
  add(f.roll_turns_without_control, 2, "without control by {} turns");
  return fmt::format("{}", fmt::join(all, "  \u00b7  "));
}

}  // namespace

std::string card_svg(const flight::Flight& flight, const Figures& figures, const Verdict& verdict) {
  const std::string_view colour = colour_of(tone(verdict));
  std::string out =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1200\" height=\"630\" viewBox=\"0 0 1200 630\" "
      "font-family=\"DejaVu Sans, sans-serif\">\n<rect width=\"1200\" height=\"630\" fill=\"#ffffff\"/>\n";
  out += fmt::format("<rect width=\"16\" height=\"630\" fill=\"{}\"/>\n", colour);
  out += text_at(left, 62.0, 22.0, "fill=\"#586069\"",
                 flight.vehicle.empty() ? "Fantail flight report" : "Fantail flight report \u00b7 " + flight.vehicle);
  out += text_at(left, 118.0, 50.0, "fill=\"#1f2933\" font-weight=\"bold\"", in_lines(flight.scenario, 32, 1).front());
  out += text_at(left, 172.0, 30.0, fmt::format("fill=\"{}\" font-weight=\"bold\"", colour),
                 display_name(verdict.outcome));
  double y = 214.0;
  for (const std::string& line : in_lines(verdict.text, 66, 3)) {
    out += text_at(left, y, 26.0, "fill=\"#1f2933\"", line);
    y += 34.0;
  }
  out += text_at(left, 322.0, 20.0, "fill=\"#586069\"", figure_row(flight, figures));
  out += roll_plot(flight);
  out += text_at(left, 612.0, 18.0, "fill=\"#586069\"",
                 flight.seed ? fmt::format("Simulated, seed {}.", *flight.seed) : "From a log.");
  return out + "</svg>\n";
}

}  // namespace fantail::report
