// SPDX-License-Identifier: MIT
#include "report/chart_drawer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "flight/columns.hpp"
#include "text/number.hpp"

namespace fantail::report {

RowValue column(std::string_view name) {
  return [found = flight::find_column(name)](const flight::Row& row) { return found->written(row); };
}

PlotWindow plot_window(const flight::Flight& flight) {
  if (flight.rows.empty()) {
    return {};
  }
  PlotWindow window{flight.rows.front().time_s, flight.rows.back().time_s};
  const flight::Events& e = flight.events;
  if (const auto start = e.liftoff_s ? e.liftoff_s : e.control_start_s) {
    window.begin_s = std::max(window.begin_s, *start - 1.0);
  }
  if (e.control_end_s || e.apogee_s) {
    const double over_s = std::max(e.control_end_s.value_or(window.begin_s), e.apogee_s.value_or(window.begin_s));
    window.end_s = std::min(window.end_s, over_s + 0.5);
  }
  constexpr double least_s = 0.01;  // a table may have one row, and a summary events far from its rows
  if (window.end_s - window.begin_s < least_s) {
    window = {flight.rows.front().time_s - 0.5, flight.rows.back().time_s + 0.5};
  }
  return window;
}

ChartDrawer::ChartDrawer(const flight::Flight& flight)
    : flight_{flight},
      rows_{std::ranges::lower_bound(flight.rows, plot_window(flight).begin_s, {}, &flight::Row::time_s),
            flight.rows.end()} {
  for (const flight::Row& row : rows_) {
    time_s_.push_back(row.time_s);
  }
}

page::Chart ChartDrawer::chart(std::string label, std::string unit, double width, double height,
                               std::vector<page::Series> series) const {
  return {.label = std::move(label),
          .x_label = "time / s",
          .y_label = std::move(unit),
          .width = width,
          .height = height,
          .series = std::move(series),
          .sampled = true};
}

page::Series ChartDrawer::line(std::string name, page::Role role, const RowValue& value, page::Mark mark) const {
  page::Series series{.name = std::move(name), .role = role, .mark = mark, .x = time_s_};
  std::ranges::transform(rows_, std::back_inserter(series.y), value);
  return series;
}

page::Area ChartDrawer::band(std::string name, page::Role role, std::span<const RowValue> values) const {
  page::Area area{.name = std::move(name), .role = role, .x = time_s_};
  for (const flight::Row& row : rows_) {
    double low = unknown_value;
    double high = unknown_value;
    for (const RowValue& value : values) {
      low = std::fmin(low, value(row));
      high = std::fmax(high, value(row));
    }
    area.low.push_back(low);
    area.high.push_back(high);
  }
  return area;
}

RowValue ChartDrawer::in_control(const RowValue& value) const {
  return [value, always = !flight_.known.phase](const flight::Row& row) {
    return always || row.phase == core::Phase::controlling ? value(row) : unknown_value;
  };
}

page::Chart ChartDrawer::with_limits(page::Chart chart) const {
  if (!flight_.known.plan) {
    return chart;
  }
  core::Angle stop = flight_.plan.canards.each.front().mechanical_stop;
  for (const core::CanardPlan& canard : flight_.plan.canards.each) {
    stop = std::min(stop, canard.mechanical_stop);
  }
  const core::Angle plan = flight_.plan.controller.canard_limit;
  for (const auto& [name, angle] :
       {std::pair{"plan limit", plan}, {"mechanical stop", stop}, {"hard limit", core::hard_canard_limit}}) {
    const double limit_deg = static_cast<double>(angle.degrees());
    const std::string label = fmt::format("{} {} deg", name, text::brief(limit_deg, 3));
    chart.levels.push_back({.value = limit_deg, .label = label, .role = page::Role::limit});
    chart.levels.push_back({.value = -limit_deg, .role = page::Role::limit});
  }
  const double sight_deg = 1.35 * static_cast<double>(plan.degrees());
  chart.y_range = page::Range{-sight_deg, sight_deg};
  return chart;
}

}  // namespace fantail::report
