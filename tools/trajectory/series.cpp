// SPDX-License-Identifier: MIT
#include "trajectory/series.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/core.h>

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

using Cells = std::vector<std::optional<double>>;

[[noreturn]] void refuse(const std::string& message) { throw text::Error{text::ErrorKind::bad_data, message}; }

class Reader {
 public:
  Reader(const flight::Table& table, const Columns& columns) : table_{table}, columns_{columns} {}

  Series read() {
    find_needed();
    read_rows();
    find_flight();
    look_at_pad();
    refuse_gaps();
    for (const FoundColumn& column : columns_.all()) {
      if (column.quantity != Quantity::time) {
        series_.values[column.quantity] = filled(column);
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
        refuse(fmt::format("{}:{}: no column for the {}: {}; the columns are: {}", table_.name(), table_.header_line(),
                           what, names, there));
      }
      needed_.push_back(column);
      series_.needed.push_back(column->quantity);
    };
    const auto either = [this](Quantity first, Quantity second) {
      return columns_.has(first) ? columns_.find(first) : columns_.find(second);
    };
    const auto names = [](Quantity a, Quantity b) { return names_of(a) + " or " + names_of(b); };
    need(columns_.find(Quantity::time), "time", names_of(Quantity::time));
    need(either(Quantity::height, Quantity::height_above_sea), "height",
         names(Quantity::height, Quantity::height_above_sea));
    need(either(Quantity::speed, Quantity::up), "speed", names(Quantity::speed, Quantity::up));
  }

  [[nodiscard]] std::optional<double> number(std::size_t row, const FoundColumn& column) const {
    const auto written = table_.number(row, column.index);
    if (!written) {
      return std::nullopt;
    }
    const double value = *written * column.scale + column.offset;
    if (!(value >= column.least && value <= column.most)) {
      refuse(fmt::format("{}: {} = {} is {} in SI; allowed: {} to {}", table_.where(row), column.name,
                         flight::in_quotes(table_.cell(row, column.index)), input::about(value),
                         input::about(column.least), input::about(column.most)));
    }
    return value;
  }

  void read_rows() {
    std::size_t left_out = 0;
    std::size_t repeated = 0;
    std::string first;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const auto lacks = std::ranges::find_if(needed_, [&](const FoundColumn* c) { return !number(row, *c); });
      if (lacks != needed_.end()) {
        first = first.empty() ? fmt::format("line {}, {} {}", table_.line(row), (*lacks)->name,
                                            flight::in_quotes(table_.cell(row, (*lacks)->index)))
                              : first;
        ++left_out;
        continue;
      }
      const double time_s = *number(row, *needed_[0]);
      if (!series_.times_s.empty() && time_s < series_.times_s.back()) {
        refuse(fmt::format("{}: the time is {} s after {} s in line {}: it must increase", table_.where(row),
                           input::plain_number(time_s), input::plain_number(series_.times_s.back()),
                           series_.lines.back()));
      }
      if (!series_.times_s.empty() && time_s < series_.times_s.back() + rounding_s) {
        ++repeated;
        continue;
      }
      series_.times_s.push_back(time_s);
      series_.lines.push_back(table_.line(row));
      rows_.push_back(row);
    }
    if (left_out > 0) {
      const std::string said =
          fmt::format("{} of {} rows have no number where one is needed (first: {})", left_out, table_.rows(), first);
      if (100 * left_out > table_.rows()) {
        refuse(fmt::format("{}: {}; more than 1 % is too many", table_.name(), said));
      }
      series_.notes.push_back(said + "; they are left out.");
    }
    if (repeated > 0) {
      series_.notes.push_back(
          fmt::format("{} of {} rows have the time of the row before; they are left out.", repeated, table_.rows()));
    }
    if (rows_.size() < 2) {
      refuse(fmt::format("{}: {} after the header; a flight is needed", table_.name(),
                         rows_.empty() ? "no rows" : "one row"));
    }
  }

  void find_flight() {
    const auto speed = [this](std::size_t i) { return std::abs(*number(rows_[i], *needed_[2])); };
    const auto height = [this](std::size_t i) { return *number(rows_[i], *needed_[1]); };
    std::size_t first = 0;
    std::size_t highest = 0;
    while (first < rows_.size() && speed(first) <= rest_m_s) {
      ++first;
    }
    if (first == rows_.size()) {
      refuse(
          fmt::format("{}: the rocket never moves: {} stays below {} m/s", table_.name(), needed_[2]->name, rest_m_s));
    }
    if (first == 0 && speed(0) > first_speed_m_s) {
      refuse(fmt::format("{}: {} is {} m/s in the first row; the flight must begin at rest on the pad",
                         table_.where(rows_[0]), needed_[2]->name, input::about(speed(0))));
    }
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      highest = height(i) > height(highest) ? i : highest;
    }
    series_.liftoff = first == 0 ? 0 : first - 1;
    series_.apogee = highest;
    series_.climbs_to_the_end = highest + 1 == rows_.size();
    if (highest <= series_.liftoff) {
      refuse(fmt::format("{}: the rocket moves and does not rise: {} is highest in line {}", table_.name(),
                         needed_[1]->name, series_.lines[highest]));
    }
  }

  void look_at_pad() {
    const std::size_t row = rows_[series_.liftoff];
    const FoundColumn& column = *needed_[1];
    const double height_m = *number(row, column);
    if (column.quantity != Quantity::height || std::abs(height_m) < worth_saying_m) {
      return;
    }
    if (std::abs(height_m) > highest_pad_m) {
      refuse(
          fmt::format("{}: {} = {} is {} m above the launch site at lift-off; allowed: {} to {} m. A height above the "
                      "sea is to be exported as {}; otherwise the file lacks the beginning of the flight",
                      table_.where(row), column.name, flight::in_quotes(table_.cell(row, column.index)),
                      input::about(height_m), -highest_pad_m, highest_pad_m, names_of(Quantity::height_above_sea)));
    }
    series_.notes.push_back(
        fmt::format("{} is {} m at lift-off; heights count from there.", column.name, input::about(height_m)));
  }

  void refuse_gaps() const {
    for (std::size_t i = series_.liftoff + 1; i <= series_.apogee; ++i) {
      const double gap_s = series_.times_s[i] - series_.times_s[i - 1];
      if (gap_s > longest_gap_s + rounding_s) {
        refuse(
            fmt::format("{}:{}: {} s after the row before; at most {} s are allowed from lift-off to apogee. "
                        "RocketPy: export_data(..., time_step=0.01); OpenRocket: a smaller time step of the "
                        "simulation",
                        table_.name(), series_.lines[i], input::about(gap_s), longest_gap_s));
      }
    }
  }

  /// A straight line over cells without a number, and the next number at both ends.
  [[nodiscard]] std::vector<double> filled(const FoundColumn& column) {
    std::vector<double> values(rows_.size());
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
        const double share =
            (times_s[j] - times_s[before]) / (times_s[std::min(end, rows_.size() - 1)] - times_s[before]);
        values[j] = from + share * (to - from);
      }
    };
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (const auto value = number(rows_[i], column)) {
        fill(i, known > 0 ? values[known - 1] : *value, *value);
        values[i] = *value;
        known = i + 1;
      }
    }
    const double last = known > 0 ? values[known - 1] : 0.0;
    fill(rows_.size(), last, last);
    if (missing > 0) {
      series_.notes.push_back(
          fmt::format("{} of {} cells of {} hold no number; they are filled from those around them.", missing,
                      rows_.size(), column.name));
    }
    return values;
  }

  /// Of rows [begin, end), none of which has a number: is that too long a part of the flight?
  void refuse_hole(const FoundColumn& column, std::size_t begin, std::size_t end) const {
    const std::size_t from = std::max(begin == 0 ? 0 : begin - 1, series_.liftoff);
    const std::size_t to = std::min(end, series_.apogee);
    if (end - begin == rows_.size() ||
        (to > from && series_.times_s[to] - series_.times_s[from] > longest_gap_s + rounding_s)) {
      refuse(
          fmt::format("{}:{}: {} holds no number until line {}; at most {} s without are allowed from lift-off to "
                      "apogee",
                      table_.name(), series_.lines[begin], column.name, series_.lines[std::min(end, rows_.size() - 1)],
                      longest_gap_s));
    }
  }

  const flight::Table& table_;
  const Columns& columns_;
  std::vector<const FoundColumn*> needed_;
  std::vector<std::size_t> rows_;  ///< of the table, those that are kept
  Series series_;
};

}  // namespace

Series read_series(const flight::Table& table, const Columns& columns) { return Reader{table, columns}.read(); }

}  // namespace fantail::trajectory
