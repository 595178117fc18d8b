// SPDX-License-Identifier: MIT
#include "trajectory/series.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/core.h>

#include "files/rows.hpp"
#include "input/messages.hpp"
#include "text/error.hpp"

namespace fantail::trajectory {
namespace {

constexpr double longest_gap_s = 0.1;
constexpr double rounding_s = 1e-6;  // rows nearer than this are of one instant
// Interpolation between steps makes a rocket on the pad move by less.
constexpr double rest_m_s = 0.01;
constexpr double first_speed_m_s = 1.0;
// A tower, a slope or a rounded elevation of the site explains no more. Within it nothing is lost: heights count from
// lift-off.
constexpr double highest_pad_m = 50.0;
constexpr double worth_saying_m = 0.5;

class Reader {
 public:
  Reader(const flight::Table& table, const Columns& columns) : table_{table}, columns_{columns} {}

  Series read() {
    find_needed();
    read_rows();
    find_flight();
    look_at_pad();
    refuse_gaps();
    for (std::size_t i = 0; i < columns_.all().size(); ++i) {
      const FoundColumn& column = columns_.all()[i];
      if (column.quantity != Quantity::time) {
        series_.values[column.quantity] = filled(column, rows_.values[needed_.size() + i]);
      }
    }
    return series_;
  }

 private:
  void find_needed() {
    const auto need = [this](const FoundColumn* column, const std::string& what, const std::string& names) {
      if (column == nullptr) {
        std::string there;
        for (const std::string& name : table_.columns()) {
          there += (there.empty() ? "" : ", ") + flight::in_quotes(name);
        }
        text::refuse(fmt::format("{}:{}: no column for the {}: {}; the columns are: {}", table_.name(),
                                 table_.header_line(), what, names, there));
      }
      needed_.push_back(column);
      series_.needed.push_back(column->quantity);
    };
    const auto either = [this](Quantity first, Quantity second) {
      return columns_.find(first) != nullptr ? columns_.find(first) : columns_.find(second);
    };
    const auto names = [](Quantity a, Quantity b) { return names_of(a) + " or " + names_of(b); };
    need(columns_.find(Quantity::time), "time", names_of(Quantity::time));
    need(either(Quantity::height, Quantity::height_above_the_sea), "height",
         names(Quantity::height, Quantity::height_above_the_sea));
    need(either(Quantity::total_speed, Quantity::vertical_speed), "speed",
         names(Quantity::total_speed, Quantity::vertical_speed));
  }

  void read_rows() {
    std::vector<files::Found> columns;
    for (const FoundColumn* const column : needed_) {
      columns.push_back(column->found);
      columns.back().needed = true;
    }
    for (const FoundColumn& column : columns_.all()) {
      columns.push_back(column.found);
    }
    rows_ =
        files::read_rows(table_, columns, {.same_time = files::SameTime::first_counts, .same_within_s = rounding_s});
    series_.notes = rows_.notes;
    series_.times_s = rows_.values[0];
    for (const std::size_t row : rows_.rows) {
      series_.lines.push_back(table_.line(row));
    }
    if (count() < 2) {
      text::refuse(fmt::format("{}: {} after the header; a flight is needed", table_.name(),
                               count() == 0 ? "no rows" : "one row"));
    }
  }

  [[nodiscard]] std::size_t count() const { return rows_.rows.size(); }

  void find_flight() {
    const auto speed = [this](std::size_t i) { return std::abs(rows_.values[2][i]); };
    const auto height = [this](std::size_t i) { return rows_.values[1][i]; };
    std::size_t first = 0;
    std::size_t highest = 0;
    while (first < count() && speed(first) <= rest_m_s) {
      ++first;
    }
    if (first == count()) {
      text::refuse(
          fmt::format("{}: the rocket never moves: {} stays below {} m/s", table_.name(), needed_[2]->name, rest_m_s));
    }
    if (first == 0 && speed(0) > first_speed_m_s) {
      text::refuse(fmt::format("{}: {} is {} m/s in the first row; the flight must begin at rest on the pad",
                               table_.where(rows_.rows[0]), needed_[2]->name, input::about(speed(0))));
    }
    for (std::size_t i = 1; i < count(); ++i) {
      highest = height(i) > height(highest) ? i : highest;
    }
    series_.liftoff = first == 0 ? 0 : first - 1;
    series_.apogee = highest;
    series_.climbs_to_the_end = highest + 1 == count();
    if (highest <= series_.liftoff) {
      text::refuse(fmt::format("{}: the rocket moves and does not rise: {} is highest in line {}", table_.name(),
                               needed_[1]->name, series_.lines[highest]));
    }
  }

  void look_at_pad() {
    const std::size_t row = rows_.rows[series_.liftoff];
    const FoundColumn& column = *needed_[1];
    const double height_m = rows_.values[1][series_.liftoff];
    if (column.quantity != Quantity::height || std::abs(height_m) < worth_saying_m) {
      return;
    }
    if (std::abs(height_m) > highest_pad_m) {
      text::refuse(
          fmt::format("{}: {} = {} is {} m above the launch site at lift-off; allowed: {} to {} m. A height above the "
                      "sea is to be exported as {}; otherwise the file lacks the beginning of the flight",
                      table_.where(row), column.name, flight::in_quotes(table_.cell(row, column.found.column)),
                      input::about(height_m), -highest_pad_m, highest_pad_m, names_of(Quantity::height_above_the_sea)));
    }
    series_.notes.push_back(
        fmt::format("{} is {} m at lift-off; heights count from there.", column.name, input::about(height_m)));
  }

  void refuse_gaps() const {
    for (std::size_t i = series_.liftoff + 1; i <= series_.apogee; ++i) {
      const double gap_s = series_.times_s[i] - series_.times_s[i - 1];
      if (gap_s > longest_gap_s + rounding_s) {
        text::refuse(
            fmt::format("{}:{}: {} s after the row before; at most {} s are allowed from lift-off to apogee. "
                        "RocketPy: export_data(..., time_step=0.01); OpenRocket: a smaller time step of the "
                        "simulation",
                        table_.name(), series_.lines[i], input::about(gap_s), longest_gap_s));
      }
    }
  }

  /// A straight line over cells without a number, and the next number at both ends.
  [[nodiscard]] std::vector<double> filled(const FoundColumn& column, std::vector<double> values) {
    std::size_t known = 0;  // rows before this one have their value
    std::size_t missing = 0;
    const auto fill = [&](std::size_t end, double from, double to) {
      if (known == end) {
        return;
      }
      refuse_hole(column, known, end);
      missing += end - known;
      const std::vector<double>& times_s = series_.times_s;
      const std::size_t before = known > 0 ? known - 1 : 0;
      for (std::size_t j = known; j < end; ++j) {
        const double share = (times_s[j] - times_s[before]) / (times_s[std::min(end, count() - 1)] - times_s[before]);
        values[j] = from + share * (to - from);
      }
    };
    for (std::size_t i = 0; i < count(); ++i) {
      if (!std::isnan(values[i])) {
        fill(i, known > 0 ? values[known - 1] : values[i], values[i]);
        known = i + 1;
      }
    }
    const double last = known > 0 ? values[known - 1] : 0.0;
    fill(count(), last, last);
    if (missing > 0) {
      series_.notes.push_back(
          fmt::format("{} of {} cells of {} are not numbers; they are filled from those around them.", missing, count(),
                      column.name));
    }
    return values;
  }

  /// Of rows [begin, end), none of which has a number: is that too long a part of the flight?
  void refuse_hole(const FoundColumn& column, std::size_t begin, std::size_t end) const {
    const std::size_t from = std::max(begin == 0 ? 0 : begin - 1, series_.liftoff);
    const std::size_t to = std::min(end, series_.apogee);
    if (end - begin == count() ||
        (to > from && series_.times_s[to] - series_.times_s[from] > longest_gap_s + rounding_s)) {
      text::refuse(fmt::format(
          "{}:{}: {} has no number until line {}; at most {} s without one are allowed from lift-off to "
          "apogee",
          table_.name(), series_.lines[begin], column.name, series_.lines[std::min(end, count() - 1)], longest_gap_s));
    }
  }

  const flight::Table& table_;
  const Columns& columns_;
  std::vector<const FoundColumn*> needed_;
  files::Rows rows_;  ///< of the needed columns and then of all
  Series series_;
};

}  // namespace

Series read_series(const flight::Table& table, const Columns& columns) { return Reader{table, columns}.read(); }

}  // namespace fantail::trajectory
