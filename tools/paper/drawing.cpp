// SPDX-License-Identifier: MIT
#include "paper/drawing.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "plot/page.hpp"
#include "report/numbers.hpp"

namespace fantail::paper {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double true_degrees(const report::Row& row, double report::Truth::* member) {
  return row.truth ? report::degrees((*row.truth).*member) : unknown;
}

}  // namespace

std::string half_width_figure(plot::Chart chart, const std::string& caption) {
  chart.width = 500.0;
  chart.height = 240.0;
  return plot::figure(plot::svg(chart), caption);
}

plot::Series curve(const Run& run, const Stretch& stretch, std::string name, plot::Role role, const RowValue& value) {
  plot::Series series{.name = std::move(name), .role = role, .mark = plot::Mark::line, .x = {}, .y = {}};
  for (const report::Row& row : run.flight.rows) {
    if (row.time_s >= stretch.from_s && row.time_s <= stretch.to_s) {
      series.x.push_back(row.time_s - stretch.zero_s);
      series.y.push_back(value(row));
    }
  }
  return series;
}

plot::Series curve(const std::vector<double>& x, std::vector<double> y, std::string name, plot::Role role) {
  return {.name = std::move(name), .role = role, .mark = plot::Mark::line, .x = x, .y = std::move(y)};
}

std::vector<double> degrees(const std::vector<double>& radians) {
  std::vector<double> all(radians.size());
  std::ranges::transform(radians, all.begin(), report::degrees);
  return all;
}

double true_angle_deg(const report::Row& row) { return true_degrees(row, &report::Truth::roll_angle_rad); }
double true_rate_deg_s(const report::Row& row) { return true_degrees(row, &report::Truth::roll_rate_rad_s); }
double true_canard_deg(const report::Row& row) { return true_degrees(row, &report::Truth::canard_rad); }
double true_disturbance_deg(const report::Row& row) { return true_degrees(row, &report::Truth::disturbance_rad); }

}  // namespace fantail::paper
