// SPDX-License-Identifier: MIT
#include "logs/roll_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "logs/words.hpp"
#include "sim/input/messages.hpp"
#include "sim/input_error.hpp"

namespace fantail::logs {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw sim::InputError{sim::InputFault::bad_data, message}; }

std::optional<core::Phase> phase_named(std::string_view word) {
  for (const auto phase : {core::Phase::safe, core::Phase::armed, core::Phase::launched, core::Phase::controlling,
                           core::Phase::finished}) {
    if (word == core::name(phase)) {
      return phase;
    }
  }
  return {};
}

// Fills the lists of a log row by row.
class Rows {
 public:
  Rows(const Table& table, std::span<const FoundColumn> columns, std::optional<std::size_t> phase, RollLog& log)
      : table_{table}, columns_{columns}, phase_{phase}, log_{log}, values_(columns_.size()) {
    for (const FoundColumn& column : columns_) {
      (log_.*column.list).reserve(table_.rows());
    }
  }

  void read_all() {
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      if (!read(row)) {
        ++log_.rows_left_out;
      } else if (!repeats(row)) {
        keep(row);
      } else {
        ++log_.rows_repeated;
      }
    }
    judge_count();
    // An empty column is as good as none.
    for (const FoundColumn& column : columns_) {
      std::vector<double>& list = log_.*column.list;
      if (std::ranges::all_of(list, [](double value) { return std::isnan(value); })) {
        list.clear();
      }
    }
  }

 private:
  bool read(std::size_t row) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const auto value = table_.number(row, columns_[i].index);
      if (!value && columns_[i].needed) {
        if (first_left_out_.empty()) {
          first_left_out_ = fmt::format("line {}, {} {}", table_.line(row), columns_[i].name,
                                        in_quotes(table_.cell(row, columns_[i].index)));
        }
        return false;
      }
      values_[i] = value.value_or(std::numeric_limits<double>::quiet_NaN());
    }
    return true;
  }

  bool repeats(std::size_t row) const {
    if (log_.time_s.empty() || values_[0] > log_.time_s.back()) {
      return false;
    }
    const std::string times = fmt::format("{}: time_s is {}", table_.where(row), sim::input::shown(values_[0]));
    if (values_[0] < log_.time_s.back()) {
      refuse(fmt::format("{} after {} in line {}: time goes back", times, sim::input::shown(log_.time_s.back()),
                         last_line_));
    }
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const double before = (log_.*columns_[i].list).back();
      if (before != values_[i] && !(std::isnan(before) && std::isnan(values_[i]))) {
        refuse(fmt::format("{} as in line {}, but {} is another: two rows may share a time only when they are the same",
                           times, last_line_, columns_[i].name));
      }
    }
    return true;
  }

  void keep(std::size_t row) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      (log_.*columns_[i].list).push_back(values_[i]);
    }
    last_line_ = table_.line(row);
    if (!phase_) {
      return;
    }
    if (const auto phase = phase_named(table_.cell(row, *phase_))) {
      log_.phase.push_back(*phase);
    } else {
      log_.warnings.push_back(fmt::format("{}: {} is no flight phase; the column is not used", table_.where(row),
                                          in_quotes(table_.cell(row, *phase_))));
      log_.phase.clear();
      phase_.reset();
    }
  }

  void judge_count() {
    const std::size_t rows = table_.rows();
    if (log_.rows_left_out > 0) {
      const std::string said = fmt::format("{} of {} rows have no number where one is needed (first: {})",
                                           log_.rows_left_out, rows, first_left_out_);
      if (log_.rows_left_out * 100 > rows) {
        refuse(fmt::format("{}: {}; more than 1 % is too many", table_.name(), said));
      }
      log_.warnings.push_back(said + "; they are left out");
    }
    if (log_.rows_repeated > 0) {
      log_.warnings.push_back(
          fmt::format("{} of {} rows repeat the one before them; they are left out", log_.rows_repeated, rows));
    }
    if (log_.time_s.size() < 2) {
      refuse(fmt::format("{}: {} rows with numbers; at least two are needed", table_.name(), log_.time_s.size()));
    }
  }

  const Table& table_;
  std::span<const FoundColumn> columns_;
  std::optional<std::size_t> phase_;
  RollLog& log_;
  std::vector<double> values_;
  std::string first_left_out_;
  std::size_t last_line_ = 0;
};

}  // namespace

void read_roll_rows(const Table& table, std::span<const FoundColumn> columns, std::optional<std::size_t> phase,
                    RollLog& log) {
  Rows{table, columns, phase, log}.read_all();
}

}  // namespace fantail::logs
