// SPDX-License-Identifier: MIT
#include "bench/sheet_charts.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/core.h>

#include "bench/chart.hpp"
#include "bench/course.hpp"
#include "report/escape.hpp"
#include "report/numbers.hpp"

namespace fantail::bench {
namespace {

using report::degrees;
using report::fixed;

constexpr std::size_t before_step = 20;
constexpr std::size_t after_step = 200;

Chart chart_of(const Course& course, const Window& window, std::size_t zero, double ticks_per_unit) {
  Chart chart;
  for (std::size_t i = window.begin; i < window.end; ++i) {
    chart.time.push_back((static_cast<double>(i) - static_cast<double>(zero)) / ticks_per_unit);
    chart.command_deg.push_back(degrees(course.command_rad[i]));
    chart.encoder_deg.push_back(degrees(course.encoder_rad[i]));
  }
  return chart;
}

void add_limits(Chart& chart, double limit_rad) {
  const std::string text = fmt::format("limit {}\u00b0", report::brief(degrees(limit_rad), 2));
  chart.levels = {{degrees(limit_rad), text}, {-degrees(limit_rad), ""}};
}

// The stretches in which a canard is looked at while it stands.
void add_bands(Chart& chart, const Course& course) {
  constexpr std::array<std::pair<Part, const char*>, 4> shown{{{Part::hold_positive, "at + limit"},
                                                               {Part::centre_from_above, "from above"},
                                                               {Part::hold_negative, "at \u2212 limit"},
                                                               {Part::centre_from_below, "from below"}}};
  for (const auto& [part, label] : shown) {
    if (const Window rest = at_rest(course, part); rest.size() > 0) {
      chart.bands.push_back({static_cast<double>(rest.begin) * tick_s, static_cast<double>(rest.end) * tick_s, label});
    }
  }
}

std::string figure(const Chart& chart, const std::string& caption) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", chart_svg(chart), caption);
}

std::string whole_turn(const Course& course, const Sheet& sheet, std::size_t canard, const std::string& caption) {
  Chart chart = chart_of(course, {0, course.size()}, 0, 1.0 / tick_s);
  chart.label = fmt::format("Canard {}: command and encoder over time, {}", canard + 1, caption);
  if (sheet.kind != ExerciseKind::limits) {
    chart.width = 900.0;  // alone on its row
    chart.height = 260.0;
    chart.buckets = 260;
  }
  add_limits(chart, sheet.bounds.limit_rad[canard]);
  add_bands(chart, course);
  return figure(chart, caption);
}

std::string step_detail(const Course& course, Part part, std::size_t canard, const std::string& caption) {
  const std::size_t begin = step_begin(course, part);
  if (begin >= course.size()) {
    return {};
  }
  Chart chart = chart_of(
      course, {begin > before_step ? begin - before_step : 0, std::min(begin + after_step, course.size())}, begin, 1.0);
  chart.label = fmt::format("Canard {}: a step in detail", canard + 1);
  chart.height = 150.0;
  chart.time_unit = "ms";
  return figure(chart, caption);
}

std::string with_value(std::string_view words, const std::optional<double>& value, int decimals,
                       std::string_view unit) {
  return value ? fmt::format("{} {} {}", words, fixed(*value, decimals), unit) : fmt::format("{}, not measured", words);
}

}  // namespace

std::string canard_charts(const CanardResult& result, const Sheet& sheet, const link::Recording& recording,
                          const Exercise& exercise) {
  std::string alone;
  std::string together;
  std::string steps;
  for (const Turn& turn : exercise.turns()) {
    if (turn.canard && *turn.canard != result.canard) {
      continue;
    }
    const Course own = course(recording, exercise, turn, result.canard);
    if (own.size() == 0) {
      continue;
    }
    if (!turn.canard) {
      together = whole_turn(own, sheet, result.canard, "All four together");
      continue;
    }
    alone = whole_turn(own, sheet, result.canard, "Alone");
    const Figures& f = result.alone->figures;
    const auto slew_deg_s = f.slew_rad_s ? std::optional{degrees(*f.slew_rad_s)} : std::nullopt;
    const std::string rise = with_value("Step from the centre: 10 to 90 % in",
                                        f.step_time_s ? std::optional{1e3 * *f.step_time_s} : std::nullopt, 0, "ms");
    steps = step_detail(own, Part::step_out, result.canard, rise);
    steps += sheet.kind == ExerciseKind::step
                 ? step_detail(own, Part::step_home, result.canard, "Step back")
                 : step_detail(own, Part::step_across, result.canard,
                               with_value("Limit to limit: at most", slew_deg_s, 0, "deg/s"));
  }
  return fmt::format("<div class=\"charts{}\">\n{}</div>\n", sheet.kind == ExerciseKind::limits ? "" : " single",
                     alone + together + steps);
}

}  // namespace fantail::bench
