// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "flight/columns.hpp"
#include "flight/table.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"

namespace fantail::flight {

/// A column of a table of points, each of which is a struct of numbers with a time_s.
template <typename Point>
struct PointColumn {
  const char* name;
  double Point::* member;
  bool in_degrees = false;  ///< the point holds radians
};

/// One row a point.
template <typename Point>
std::string write_points(const std::vector<Point>& points, std::span<const PointColumn<Point>> columns) {
  std::string out;
  for (const PointColumn<Point>& column : columns) {
    out.append(out.empty() ? "" : ",").append(column.name);
  }
  out.push_back('\n');
  for (const Point& point : points) {
    for (const PointColumn<Point>& column : columns) {
      const double value = point.*column.member;
      const SixDecimals decimals{column.in_degrees ? text::degrees(value) : value};
      out += decimals.text();
      out.push_back(&column == &columns.back() ? '\n' : ',');
    }
  }
  return out;
}

/// The other way. Throws text::Error (bad_data) for a missing column, a cell without a number, time that does not
/// increase.
template <typename Point>
std::vector<Point> read_points(const Table& table, std::span<const PointColumn<Point>> columns) {
  std::vector<Point> points(table.rows());
  for (const PointColumn<Point>& column : columns) {
    const std::size_t place = table.column(column.name);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const auto value = table.number(row, place);
      if (!value) {
        throw text::Error{text::ErrorKind::bad_data, table.where(row) + ": " + column.name + " = " +
                                                         in_quotes(table.cell(row, place)) + " is not a number"};
      }
      points[row].*column.member = column.in_degrees ? text::radians(*value) : *value;
    }
  }
  for (std::size_t row = 1; row < points.size(); ++row) {
    if (points[row].time_s <= points[row - 1].time_s) {
      throw text::Error{text::ErrorKind::bad_data, table.where(row) + ": time_s must increase"};
    }
  }
  return points;
}

}  // namespace fantail::flight
