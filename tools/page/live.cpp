// SPDX-License-Identifier: MIT
#include "page/live.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "json/value.hpp"
#include "page/page.hpp"
#include "page/parts.hpp"
#include "page/svg_plot.hpp"

namespace fantail::page {
namespace {

using Json = json::Value;

// To a hundredth; integers are shorter than "12.30", so the page divides by 100.
Json hundredths(double value) {
  if (!std::isfinite(value) || std::abs(value) > 1e12) {
    return {};
  }
  return static_cast<std::int64_t>(std::llround(value * 100.0));
}

struct Point {
  double time_s;
  std::optional<std::size_t> sample;  // empty: nothing is known there, and no line goes across
};

std::vector<Point> points_of(const std::vector<double>& time_s, std::span<const std::vector<double>> columns,
                             std::size_t buckets) {
  const std::vector<std::size_t> missing_before = gaps(time_s);
  std::vector<Point> drawn_points;
  auto next_gap = missing_before.begin();
  for (const std::size_t i : keep_extremes(columns, buckets)) {
    for (; next_gap != missing_before.end() && *next_gap <= i; ++next_gap) {
      if (!drawn_points.empty()) {
        drawn_points.push_back({0.5 * (time_s[*next_gap - 1] + time_s[*next_gap]), {}});
      }
    }
    drawn_points.push_back({time_s[i], i});
  }
  return drawn_points;
}

Json levels_of(const Chart& chart) {
  Json levels = Json::array();
  for (const Level& level : chart.levels) {
    if (!level.upright) {
      levels.push_back(
          {{"value", json::rounded(level.value, 3)}, {"label", level.label}, {"role", class_of(level.role)}});
    }
  }
  return levels;
}

Json hundredths(const std::vector<double>& values) {
  Json all = Json::array();
  for (const double value : values) {
    all.push_back(hundredths(value));
  }
  return all;
}

Json decimetres(const std::vector<double>& values_m) {
  Json all = Json::array();
  for (const double value_m : values_m) {
    all.push_back(std::isfinite(value_m) ? Json(static_cast<std::int64_t>(std::llround(value_m * 10.0))) : Json{});
  }
  return all;
}

Json data_of(const ScenePath& path) {
  return {
      {"north", decimetres(path.north_m)},
      {"east", decimetres(path.east_m)},
      {"height", decimetres(path.height_m)},
      {"wind", path.wind ? Json{{"to", json::rounded(path.wind->to_rad, 3)}, {"words", path.wind->words}} : Json{}}};
}

Json data_of(const RollScene& scene) {
  Json canards = Json::array();
  for (const std::vector<double>& one : scene.canards_deg) {
    canards.push_back(hundredths(one));
  }
  return {{"name", scene.name},
          {"note", scene.note},
          {"begin", json::rounded(scene.begin_s, 3)},
          {"step", json::rounded(scene.step_s, 3)},
          {"shown", json::rounded(scene.shown_s, 3)},
          {"from", json::rounded(scene.from_s, 3)},
          {"roll", hundredths(scene.roll_deg)},
          {"free", scene.without_control_deg.empty() ? Json{} : hundredths(scene.without_control_deg)},
          {"canards", std::move(canards)},
          {"path", scene.path ? data_of(*scene.path) : Json{}}};
}

Json data_of(const Chart& chart) {
  std::vector<std::vector<double>> columns;
  Json series = Json::array();
  for (const Series& one : chart.series) {
    if (anything_in(one)) {
      columns.push_back(one.y);
      series.push_back({{"name", one.name}, {"role", class_of(one.role)}, {"step", one.mark == Mark::step}});
    }
  }
  Json bands = Json::array();
  for (const Area& area : chart.areas) {
    if (anything_in(area)) {
      bands.push_back({{"low", columns.size()}, {"high", columns.size() + 1}, {"role", class_of(area.role)}});
      columns.push_back(area.low);
      columns.push_back(area.high);
      const Json edge{{"name", ""}, {"role", class_of(area.role)}, {"step", false}, {"edge", true}};
      series.push_back(edge);
      series.push_back(edge);
      series[series.size() - 1]["name"] = area.name;
    }
  }
  if (columns.empty()) {
    return {};
  }
  const bool wide = chart.width > half_page;
  const std::vector<Point> drawn_points = points_of(chart.series.front().x, columns, wide ? 1500 : 800);
  Json times = Json::array();
  for (const Point& point : drawn_points) {
    times.push_back(static_cast<std::int64_t>(std::llround(point.time_s * 1000.0)));
  }
  for (std::size_t s = 0; s < columns.size(); ++s) {
    Json values = Json::array();
    for (const Point& point : drawn_points) {
      values.push_back(point.sample ? hundredths(columns[s][*point.sample]) : Json{});
    }
    series[s]["hundredths"] = std::move(values);
  }
  Json data{{"title", chart.label},        {"unit", chart.y_label},      {"wide", wide},
            {"height", chart.height},      {"levels", levels_of(chart)}, {"milliseconds", std::move(times)},
            {"series", std::move(series)}, {"bands", std::move(bands)}};
  if (chart.y_range) {
    data["sight"] = {{"low", chart.y_range->low}, {"high", chart.y_range->high}};
  }
  return data;
}

std::string data_of(const LiveCharts& live) {
  Json views = Json::array();
  for (const LiveCharts::View& view : live.views) {
    views.push_back({{"label", view.label}, {"begin", view.begin_s}, {"end", view.end_s}});
  }
  Json stripes = Json::array();
  for (const ShadedRange& stripe : live.charts.front().shaded_ranges) {
    stripes.push_back(
        {{"label", stripe.label}, {"role", class_of(stripe.role)}, {"begin", stripe.begin}, {"end", stripe.end}});
  }
  Json events = Json::array();
  for (const Level& level : live.charts.front().levels) {
    if (level.upright) {
      events.push_back({{"time", level.value}, {"label", level.label}});
    }
  }
  Json plots = Json::array();
  for (const Chart& chart : live.charts) {
    if (Json one = data_of(chart); !one.is_null()) {
      plots.push_back(std::move(one));
    }
  }
  for (const Chart& chart : live.more) {
    if (Json one = data_of(chart); !one.is_null()) {
      one["more"] = true;
      plots.push_back(std::move(one));
    }
  }
  return Json{{"views", views}, {"stripes", stripes},      {"events", events},
              {"plots", plots}, {"more", live.more_label}, {"scene", live.scene ? data_of(*live.scene) : Json{}}}
      .dump();
}

}  // namespace

std::string live_figure(const LiveCharts& live, std::string_view caption) {
  if (live.charts.empty()) {
    return {};
  }
  Chart chart = live.charts.front();
  std::erase_if(chart.series, [](const Series& one) { return !anything_in(one); });
  chart.height += 60.0;  // for legend and events, which have rows of their own where scripts run
  chart.x_range = Range{live.views.front().begin_s, live.views.front().end_s};
  return fmt::format("<div id=\"live\">\n{}</div>\n", figure(standalone(svg(chart)), caption));
}

std::string live_scripts(const LiveCharts& live) {
  if (live.charts.empty()) {
    return {};
  }
  return fmt::format(
      "<script type=\"application/json\" id=\"live-data\">{}</script>\n<script>\n/*\n{}*/\n{}</script>\n<script>\n{}{}"
      "</script>\n",
      escape_script_json(data_of(live)), uplot_licence, uplot_js,
      live.scene ? fmt::format("{}{}{}", rocket_js, path_js, scene_js) : "", live_js);
}

}  // namespace fantail::page
