// SPDX-License-Identifier: MIT
#include <limits>
#include <utility>

#include "page/page.hpp"
#include "paper/runs.hpp"
#include "text/degrees.hpp"

namespace fantail::paper {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double true_degrees(const flight::Row& row, double flight::Truth::* member) {
  return row.truth ? text::degrees((*row.truth).*member) : unknown;
}

}  // namespace

std::string half_width_figure(page::Chart chart, const std::string& caption) {
  chart.width = 500.0;
  chart.height = 240.0;
  return page::figure(chart, caption);
}

page::Series curve(const Run& run, const Stretch& stretch, std::string name, page::Role role, const RowValue& value) {
  page::Series series{.name = std::move(name), .role = role};
  for (const flight::Row& row : run.flight.rows) {
    if (row.time_s >= stretch.from_s && row.time_s <= stretch.to_s) {
      series.x.push_back(row.time_s - stretch.zero_s);
      series.y.push_back(value(row));
    }
  }
  return series;
}

page::Series curve(const std::vector<double>& x, std::vector<double> y, std::string name, page::Role role) {
  return {.name = std::move(name), .role = role, .x = x, .y = std::move(y)};
}

double true_angle_deg(const flight::Row& row) { return true_degrees(row, &flight::Truth::roll_angle_rad); }
double true_rate_deg_s(const flight::Row& row) { return true_degrees(row, &flight::Truth::roll_rate_rad_s); }
double true_canard_deg(const flight::Row& row) { return true_degrees(row, &flight::Truth::canard_rad); }
double true_disturbance_deg(const flight::Row& row) { return true_degrees(row, &flight::Truth::disturbance_rad); }

}  // namespace fantail::paper
