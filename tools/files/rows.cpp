// SPDX-License-Identifier: MIT
#include "files/rows.hpp"

#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "files/clock_time.hpp"
#include "input/messages.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::files {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

class Reader {
 public:
  Reader(const flight::Table& table, std::span<const Found> columns, const Rule& rule)
      : table_{table}, columns_{columns}, rule_{rule}, cells_(columns.size()) {
    result_.values.resize(columns.size());
    result_.lost.resize(columns.size());
  }

  Rows read() {
    find_marks();
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      if (rule_.only_where && text::flag(table_.cell(row, *rule_.only_where)) == false) {
        ++result_.not_used;
      } else if (read_cells(row)) {
        count_lost(row);
        take(row);
      }
    }
    note();
    return std::move(result_);
  }

 private:
  [[nodiscard]] const std::string& name(std::size_t i) const { return table_.columns()[columns_[i].column]; }
  [[nodiscard]] std::string_view cell(std::size_t row, std::size_t i) const {
    return table_.cell(row, columns_[i].column);
  }

  bool read_cells(std::size_t row) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      cells_[i] = value(row, i);
      if (columns_[i].needed && std::isnan(cells_[i])) {
        if (left_out_++ == 0) {
          first_left_out_ = fmt::format("{}, {} {}", table_.place(row), name(i), flight::in_quotes(cell(row, i)));
        }
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] double value(std::size_t row, std::size_t i) {
    const Found& column = columns_[i];
    if (column.is_flag) {
      const auto flag = text::flag(cell(row, i));
      return flag ? (*flag ? 1.0 : 0.0) : unknown;
    }
    const auto number = i == 0 ? time_at(row) : table_.number(row, column.column);
    if (!number || number == column.no_value || is_mark(*number, i)) {
      return unknown;
    }
    const double value = *number * column.factor + column.offset;
    if (value < column.least || value > column.most) {
      text::refuse(fmt::format("{}: {} = {} is {} in SI; allowed: {} {}", table_.where(row), name(i),
                               flight::in_quotes(cell(row, i)), input::about(value), input::about(column.least),
                               std::isinf(column.most) ? "and more" : "to " + input::about(column.most)));
    }
    return value;
  }

  /// Numbers that loggers write where they have none.
  [[nodiscard]] bool is_mark(double number, std::size_t i) const {
    constexpr double largest = 2147483647.0;
    return number == largest || number == -largest - 1.0 || number == 2.0 * largest + 1.0 ||
           (marks_[i] && number == *marks_[i]);
  }

  void find_marks() {
    marks_.resize(columns_.size());
    for (std::size_t i = 1; i < columns_.size(); ++i) {
      for (const double mark : {-999.0, -9999.0, -99999.0}) {
        bool occurs = false;
        bool is_apart = true;
        for (std::size_t row = 0; row < table_.rows() && is_apart; ++row) {
          const double number = table_.number(row, columns_[i].column).value_or(0.0);
          occurs = occurs || number == mark;
          is_apart = number == mark || std::abs(number) < std::abs(mark) * 2.0 / 3.0;
        }
        if (occurs && is_apart) {
          marks_[i] = mark;
        }
      }
    }
  }

  // As the cell has it, without what a clock or a counter began with and has wrapped around since.
  [[nodiscard]] std::optional<double> time_at(std::size_t row) {
    std::optional<double> number = table_.number(row, columns_[0].column);
    if (!number) {
      const auto clock_s = clock_time_s(cell(row, 0));
      if (!clock_s) {
        return std::nullopt;
      }
      constexpr double day_s = 86'400.0;
      const double from_s = clock_begin_s_.value_or(*clock_s);
      clock_begin_s_ = from_s;
      const double since_s = *clock_s - from_s;
      return (since_s < -0.5 * day_s ? since_s + day_s : since_s) / columns_[0].factor;
    }
    constexpr double steps = 4.0;  // it may have missed a few around its end
    for (const double size : {65'536.0, 16'777'216.0, 4'294'967'296.0}) {
      if (*number < last_count_ && last_count_ < size && last_count_ + steps * last_step_ >= size &&
          *number <= steps * last_step_ && *number >= 0.0) {
        wrapped_ += size;
        ++wraps_;
      }
    }
    last_step_ = *number > last_count_ ? *number - last_count_ : last_step_;
    last_count_ = *number;
    return *number + wrapped_;
  }

  void count_lost(std::size_t row) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      Rows::Lost& lost = result_.lost[i];
      if (std::isnan(cells_[i])) {
        lost.first_row = lost.empty + lost.words == 0 ? row : lost.first_row;
        const bool is_number = !columns_[i].is_flag && table_.number(row, columns_[i].column).has_value();
        const bool is_word = !cell(row, i).empty() && !is_number;
        ++(is_word ? lost.words : lost.empty);
      }
    }
    ++result_.read;
  }

  void take(std::size_t row) {
    if (!result_.rows.empty()) {
      const double before_s = result_.values[0].back();
      if (cells_[0] < before_s) {
        text::refuse(
            fmt::format("{} after {} in {}: time must increase", time(row), number(last_, 0), table_.place(last_)));
      }
      if (cells_[0] == before_s || cells_[0] < before_s + rule_.same_within_s) {
        merge(row);
        last_ = row;
        return;
      }
    }
    last_ = row;
    result_.rows.push_back(row);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      result_.values[i].push_back(cells_[i]);
    }
  }

  // A row with the time of the one before it.
  void merge(std::size_t row) {
    first_repeated_ = repeated_++ == 0 ? row : first_repeated_;
    for (std::size_t i = 1; i < columns_.size(); ++i) {
      double& before = result_.values[i].back();
      const bool is_same = cells_[i] == before || (std::isnan(cells_[i]) && std::isnan(before));
      if (rule_.same_time == SameTime::identical && !is_same) {
        text::refuse(fmt::format("{} as in {}, but {} differs: rows with the same time must be identical", time(row),
                                 table_.place(last_), name(i)));
      }
      if (rule_.same_time == SameTime::last_of_a_cell && !std::isnan(cells_[i])) {
        before = cells_[i];
      }
    }
  }

  [[nodiscard]] std::string number(std::size_t row, std::size_t i) const {
    return input::plain_number(table_.number(row, columns_[i].column).value_or(unknown));
  }
  [[nodiscard]] std::string time(std::size_t row) const {
    return fmt::format("{}: {} is {}", table_.where(row), name(0), number(row, 0));
  }

  void note() {
    const std::size_t rows = table_.rows();
    if (left_out_ > 0) {
      const std::string said = fmt::format("{} of {} rows have no number in a required column (first: {})", left_out_,
                                           rows, first_left_out_);
      if (static_cast<double>(left_out_) > rule_.most_left_out * static_cast<double>(rows)) {
        text::refuse(fmt::format("{}: {}; more than 1 % is too many", table_.name(), said));
      }
      result_.notes.push_back(said + "; they are left out.");
    }
    for (std::size_t i = 1; i < marks_.size(); ++i) {
      if (marks_[i]) {
        result_.notes.push_back(fmt::format("{} has {:g} where it has no number.", name(i), *marks_[i]));
      }
    }
    if (wraps_ > 0) {
      result_.notes.push_back(fmt::format("{} begins again {}; it is counted on.", name(0),
                                          wraps_ == 1 ? "once" : fmt::format("{} times", wraps_)));
    }
    if (clock_begin_s_) {
      result_.notes.push_back(fmt::format("{} is the time of a clock; it counts from the first row on.", name(0)));
    }
    if (repeated_ == 0) {
      return;
    }
    if (rule_.same_time == SameTime::identical) {
      result_.notes.push_back(
          fmt::format("{} of {} rows repeat the one before them; they are left out.", repeated_, rows));
      return;
    }
    result_.notes.push_back(fmt::format("{} of {} rows have the time of the row before them, the first in {}; {}.",
                                        repeated_, result_.read, table_.place(first_repeated_),
                                        rule_.same_time == SameTime::first_counts
                                            ? "they are left out"
                                            : "of rows with the same time the last number of each column counts"));
  }

  const flight::Table& table_;
  std::span<const Found> columns_;
  const Rule& rule_;
  std::vector<double> cells_;  ///< of the row that is being read
  std::size_t last_ = 0;       ///< the row that was read last
  std::size_t left_out_ = 0;
  std::string first_left_out_;
  std::vector<std::optional<double>> marks_;  ///< -999 and the like, where a column has one
  std::optional<double> clock_begin_s_;
  double last_count_ = 0.0;  ///< of the time, as the file has it
  double last_step_ = 0.0;
  double wrapped_ = 0.0;
  std::size_t wraps_ = 0;
  std::size_t repeated_ = 0;
  std::size_t first_repeated_ = 0;
  Rows result_;
};

}  // namespace

Found find_column(const flight::Table& table, const Sources& sources, Quantity quantity, const std::string& option) {
  const KnownQuantity& own = known(quantity);
  const Source* const source = find(sources, quantity);
  const std::string name = source != nullptr ? source->column : std::string{own.column};
  const auto column = table.find(name);
  if (!column || name.empty()) {
    const std::string advice = option.empty() ? "" : fmt::format("; name it with {} {}=COLUMN:UNIT", option, own.name);
    text::refuse(fmt::format("{}: {}{}", table.name(), flight::missing_column(name, table.columns()), advice));
  }
  Found found{.column = *column};
  if (source != nullptr) {
    found.factor = source->factor;
    found.offset = source->offset;
    found.no_value = source->no_value;
  } else if (own.dimension) {
    found.factor = own_unit(*own.dimension).si;
  }
  return found;
}

Rows read_rows(const flight::Table& table, std::span<const Found> columns, const Rule& rule) {
  return Reader{table, columns, rule}.read();
}

}  // namespace fantail::files
