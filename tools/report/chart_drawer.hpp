// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flight/flight.hpp"
#include "page/chart.hpp"
#include "text/degrees.hpp"

namespace fantail::report {

/// Of a simulated flight: its pictures show how the rocket truly rolled. Of a log: how the flight computer knew it.
[[nodiscard]] inline bool knows_true_roll(std::span<const flight::Row> rows) {
  return std::ranges::any_of(rows, [](const flight::Row& row) { return row.truth.has_value(); });
}

/// Not a number where it is not known.
[[nodiscard]] inline double roll_deg(const flight::Row& row, bool is_true) {
  if (!is_true) {
    return text::degrees(row.roll_angle_rad);
  }
  return row.truth ? text::degrees(row.truth->roll_angle_rad) : std::numeric_limits<double>::quiet_NaN();
}

/// What a chart shows of a row; not a number where nobody knows it.
using RowValue = std::function<double(const flight::Row&)>;

inline constexpr double unknown_value = std::numeric_limits<double>::quiet_NaN();

/// Heights of charts.
inline constexpr double tall_chart = 300.0;
inline constexpr double flat_chart = 200.0;
inline constexpr double small_chart = 150.0;

/// A column of flight.csv.
[[nodiscard]] RowValue column(std::string_view name);

/// What the plots show at first: from a second before lift-off or control start to half a second after control and
/// apogee, so that neither minutes on the pad nor a tumbling descent squeeze the flight. flight.csv has everything.
struct PlotWindow {
  double begin_s = 0.0;
  double end_s = 0.0;
};
[[nodiscard]] PlotWindow plot_window(const flight::Flight& flight);

/// Charts of the rows from the window's begin on, all over the same times.
class ChartDrawer {
 public:
  explicit ChartDrawer(const flight::Flight& flight);

  [[nodiscard]] page::Chart chart(std::string label, std::string unit, double width, double height,
                                  std::vector<page::Series> series) const;
  [[nodiscard]] page::Series line(std::string name, page::Role role, const RowValue& value,
                                  page::Mark mark = page::Mark::line) const;
  /// Between the smallest and the largest of some values.
  [[nodiscard]] page::Area band(std::string name, page::Role role, std::span<const RowValue> values) const;
  /// References and commands mean something only while somebody follows them.
  [[nodiscard]] RowValue in_control(const RowValue& value) const;
  /// The plan limit and a strip beyond it are always in sight.
  [[nodiscard]] page::Chart with_limits(page::Chart chart) const;

 private:
  const flight::Flight& flight_;
  std::span<const flight::Row> rows_;
  std::vector<double> time_s_{};
};

/// Command and canards in one chart: the healthy ones as a band, each other one as a line of its own.
[[nodiscard]] page::Chart canards_together(const flight::Flight& flight, const ChartDrawer& drawer);
/// One chart each.
[[nodiscard]] std::vector<page::Chart> canards_alone(const ChartDrawer& drawer);

}  // namespace fantail::report
