// SPDX-License-Identifier: MIT
#include "logs/roll_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "logs/log_doubts.hpp"
#include "logs/roll_columns.hpp"
#include "logs/table.hpp"
#include "logs/turns.hpp"
#include "logs/words.hpp"
#include "sim/input_error.hpp"
#include "sim/shown.hpp"
#include "sim/units.hpp"

namespace fantail::logs {
namespace {

using sim::InputError;
using sim::InputFault;

[[noreturn]] void refuse(const std::string& message) { throw InputError{InputFault::bad_data, message}; }

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
  Rows(const Table& table, std::vector<FoundColumn> columns, std::optional<std::size_t> phase, RollLog& log)
      : table_{table}, columns_{std::move(columns)}, phase_{phase}, log_{log}, values_(columns_.size()) {
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

  [[nodiscard]] const std::vector<FoundColumn>& columns() const { return columns_; }

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
    const std::string times = fmt::format("{}: time_s is {}", table_.where(row), sim::shown(values_[0]));
    if (values_[0] < log_.time_s.back()) {
      refuse(fmt::format("{} after {} in line {}: time goes back", times, sim::shown(log_.time_s.back()), last_line_));
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
  std::vector<FoundColumn> columns_;
  std::optional<std::size_t> phase_;
  RollLog& log_;
  std::vector<double> values_;
  std::string first_left_out_;
  std::size_t last_line_ = 0;
};

void read_events(const std::filesystem::path& file, RollLog& log) {
  std::ifstream stream{file};
  if (!stream) {
    return;  // a folder may hold nothing but the CSV
  }
  const auto summary = nlohmann::json::parse(stream, nullptr, false);
  if (!summary.is_object()) {
    refuse(file.string() + ": not the JSON of a flight's summary");
  }
  const auto events = summary.find("events");
  const auto event = [&](const char* name) -> std::optional<double> {
    if (events == summary.end() || !events->is_object()) {
      return {};
    }
    const auto found = events->find(name);
    return found != events->end() && found->is_number() ? std::optional{found->get<double>()} : std::nullopt;
  };
  log.burnout_s = event("burnout_s");
  log.apogee_s = event("apogee_s");
}

}  // namespace

RollLog read_roll_log(const std::filesystem::path& path, const Reading& reading, const Needs& needs) {
  RollLog log;
  log.name = path.string();
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(path, ignored);
  const std::filesystem::path file = is_folder ? path / "flight.csv" : path;
  if (is_folder && !std::filesystem::exists(file, ignored)) {
    throw InputError{InputFault::no_such_input, path.string() + ": this folder holds no flight.csv"};
  }
  const Table table = Table::load(file.string());
  Rows rows{table, find_roll_columns(table, reading, needs), find_phase_column(table, reading), log};
  rows.read_all();
  if (is_folder) {
    read_events(path / "summary.json", log);
  }

  note_doubtful_units(log, reading.angles);
  if (reading.angles == AngleUnit::degrees) {
    for (const FoundColumn& column : rows.columns()) {
      if (column.is_angle) {
        std::ranges::for_each(log.*column.list, [](double& angle) { angle *= sim::radians_per_degree; });
      }
    }
  }
  if (const std::size_t turns = continue_over_turns(log); turns > 0) {
    log.warnings.push_back(
        fmt::format("the roll angle jumps by a whole turn {} times; it is read as one that goes on", turns));
  }
  note_doubtful_motion(log);
  return log;
}

}  // namespace fantail::logs
