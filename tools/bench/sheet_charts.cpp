// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "bench/sheet_parts.hpp"
#include "bench/trace.hpp"
#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using page::Chart;
using page::Role;
using text::degrees;

constexpr std::size_t before_step = 20;
constexpr std::size_t after_step = 200;

Chart chart_of(const CanardTrace& trace, const Window& window, std::size_t zero, double ticks_per_unit) {
  Chart chart{.y_label = "deg",
              .width = page::half_page,
              .height = 180.0,
              .series = {{.name = "command", .role = Role::target}, {.name = "encoder"}},
              .least_left = 36.0};
  for (std::size_t i = window.begin; i < window.end; ++i) {
    const double time = (static_cast<double>(i) - static_cast<double>(zero)) / ticks_per_unit;
    for (page::Series& series : chart.series) {
      series.x.push_back(time);
    }
    chart.series[0].y.push_back(degrees(trace.command_rad[i]));
    chart.series[1].y.push_back(degrees(trace.encoder_rad[i]));
  }
  return chart;
}

std::string whole_turn(const CanardTrace& trace, const Sheet& sheet, std::size_t canard, const std::string& caption) {
  Chart chart = chart_of(trace, {0, trace.size()}, 0, 1.0 / tick_s);
  chart.label = fmt::format("Canard {}: command and encoder over time, {}", canard + 1, caption);
  chart.x_label = "time / s";
  chart.height = 205.0;  // three sheets of A4 or Letter for four canards
  if (sheet.kind != ExerciseKind::limits) {
    chart.width = page::full_page;  // alone on its row
    chart.height = 260.0;
  }
  const double limit_deg = degrees(sheet.bounds.limit_rad[canard]);
  const std::string label = fmt::format("limit {}\u00b0", text::brief(limit_deg, 2));
  chart.levels = {{.value = limit_deg, .label = label, .role = Role::limit},
                  {.value = -limit_deg, .role = Role::limit}};
  // The stretches in which a canard is looked at while it stands.
  constexpr std::array<std::pair<Part, const char*>, 4> shown{{{Part::hold_positive, "at + limit"},
                                                               {Part::centre_from_above, "from above"},
                                                               {Part::hold_negative, "at \u2212 limit"},
                                                               {Part::centre_from_below, "from below"}}};
  for (const auto& [part, name] : shown) {
    if (const Window rest = at_rest(trace, part); rest.size() > 0) {
      chart.shaded_ranges.push_back(
          {static_cast<double>(rest.begin) * tick_s, static_cast<double>(rest.end) * tick_s, name});
    }
  }
  return page::figure(chart, caption);
}

std::string step_detail(const CanardTrace& trace, Part part, std::size_t canard, const std::string& caption) {
  const std::size_t begin = step_begin(trace, part);
  if (begin >= trace.size()) {
    return {};
  }
  Chart chart = chart_of(
      trace, {begin > before_step ? begin - before_step : 0, std::min(begin + after_step, trace.size())}, begin, 1.0);
  chart.label = fmt::format("Canard {}: a step in detail", canard + 1);
  chart.x_label = "time / ms";
  return page::figure(chart, caption);
}

std::string with_value(std::string_view what, std::string_view of, const std::optional<double>& value,
                       std::string_view unit) {
  return value ? fmt::format("{}: {} {} {}", what, of, text::fixed(*value, 0), unit)
               : fmt::format("{}: not measured", what);
}

}  // namespace

std::string canard_charts(const CanardResult& result, const Sheet& sheet, const link::Recording& recording,
                          const Exercise& exercise) {
  std::vector<std::string> turns;
  std::vector<std::string> steps;
  for (const Turn& turn : exercise.turns()) {
    if (turn.canard && *turn.canard != result.canard) {
      continue;
    }
    const CanardTrace own = trace_of(recording, exercise, turn, result.canard);
    if (own.size() == 0) {
      continue;
    }
    turns.push_back(whole_turn(own, sheet, result.canard, turn.canard ? "Alone" : "All four together"));
    if (!turn.canard) {
      continue;
    }
    const Figures& f = result.alone->figures;
    const auto step_ms = f.step_time_s ? std::optional{1e3 * *f.step_time_s} : std::nullopt;
    steps = {step_detail(own, Part::step_out, result.canard,
                         with_value("Step from the centre", "10 to 90 % in", step_ms, "ms")),
             sheet.kind == ExerciseKind::step
                 ? step_detail(own, Part::step_home, result.canard, "Step back")
                 : step_detail(own, Part::step_across, result.canard,
                               with_value("Limit to limit", "at most", text::in_degrees(f.slew_rad_s), "deg/s"))};
  }
  if (sheet.kind != ExerciseKind::limits) {
    return (turns.empty() ? "" : turns.front()) + page::side_by_side(steps);
  }
  turns.insert(turns.end(), steps.begin(), steps.end());
  return page::side_by_side(turns);
}

}  // namespace fantail::bench
