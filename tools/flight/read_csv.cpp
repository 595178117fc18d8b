// SPDX-License-Identifier: MIT
#include "flight/read_csv.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "flight/columns.hpp"
#include "flight/found_columns.hpp"
#include "input/messages.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::flight {
namespace {

using text::ErrorKind;

[[noreturn]] void refuse(const std::string& message) { throw text::Error{ErrorKind::bad_data, message}; }

std::optional<core::Phase> phase_named(std::string_view word) {
  for (std::size_t i = 0; i < core::phases; ++i) {
    if (core::name(static_cast<core::Phase>(i)) == word) {
      return static_cast<core::Phase>(i);
    }
  }
  return {};
}

class Rows {
 public:
  Rows(const Table& table, const FoundColumns& columns, Flight& flight)
      : table_{table},
        columns_{columns.found()},
        phase_{columns.phase()},
        replayed_{table.find(replayed_column)},
        wrong_(columns_.size()),
        flight_{flight} {}

  void read_all() {
    flight_.rows.reserve(table_.rows());
    for (std::size_t line = 0; line < table_.rows(); ++line) {
      if (replayed_ && text::flag(table_.cell(line, *replayed_)) == false) {
        ++not_replayed_;
      } else if (const auto row = read(line); !row) {
        ++left_out_;
      } else if (repeats(*row, line)) {
        ++repeated_;
      } else {
        flight_.rows.push_back(*row);
        last_ = line;
      }
    }
    judge_count();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (wrong_[i] > 0) {
        const bool is_flag = columns_[i].column->unit == Column::Unit::flag;
        flight_.notes.push_back(
            fmt::format("{} of {} cells of {} hold {}; they are taken as not known.", wrong_[i], table_.rows(),
                        table_.columns()[columns_[i].index],
                        is_flag ? "neither 0 nor 1, nor a word for it" : "something that is no number"));
      }
    }
    flight_.known.phase = phase_.has_value();
  }

 private:
  [[nodiscard]] std::optional<double> number(std::size_t line, const FoundColumn& found) const {
    if (found.column->unit != Column::Unit::flag) {
      return table_.number(line, found.index);
    }
    const std::optional<bool> flag = text::flag(table_.cell(line, found.index));
    return flag ? std::optional{*flag ? 1.0 : 0.0} : std::nullopt;
  }

  std::optional<Row> read(std::size_t line) {
    Row row = unknown_row();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const auto& [index, column, needed, si] = columns_[i];
      if (const auto value = number(line, columns_[i])) {
        column->set(row, *value * si);
      } else if (!needed) {
        wrong_[i] += table_.cell(line, index).empty() ? 0 : 1;
      } else {
        if (first_left_out_.empty()) {
          first_left_out_ =
              fmt::format("{}, {} {}", table_.place(line), column->name, in_quotes(table_.cell(line, index)));
        }
        return {};
      }
    }
    read_phase(row, line);
    return row;
  }

  void read_phase(Row& row, std::size_t line) {
    if (!phase_) {
      return;
    }
    const std::string_view word = table_.cell(line, *phase_);
    if (const auto phase = phase_named(word)) {
      row.phase = *phase;
      return;
    }
    flight_.notes.push_back(
        fmt::format("{}: {} is not a flight phase; the column phase is ignored.", table_.where(line), in_quotes(word)));
    std::ranges::for_each(flight_.rows, [](Row& read) { read.phase = Row{}.phase; });
    phase_.reset();
  }

  [[nodiscard]] bool repeats(const Row& row, std::size_t line) const {
    if (flight_.rows.empty() || row.time_s > flight_.rows.back().time_s) {
      return false;
    }
    const Row& before = flight_.rows.back();
    const std::string times = fmt::format("{}: time_s is {}", table_.where(line), input::plain_number(row.time_s));
    if (row.time_s < before.time_s) {
      refuse(fmt::format("{} after {} in {}: time must increase", times, input::plain_number(before.time_s),
                         table_.place(last_)));
    }
    for (const FoundColumn& found : columns_) {
      const double now = found.column->get(row);
      const double then = found.column->get(before);
      if (now != then && !(std::isnan(now) && std::isnan(then))) {
        refuse(fmt::format("{} as in {}, but {} differs: rows with the same time must be identical", times,
                           table_.place(last_), found.column->name));
      }
    }
    return true;
  }

  void judge_count() const {
    const std::size_t rows = table_.rows();
    if (not_replayed_ > 0) {
      flight_.notes.push_back(fmt::format("{} of {} rows are of ticks that could not be replayed; they are left out.",
                                          not_replayed_, rows));
    }
    if (left_out_ > 0) {
      const std::string said = fmt::format("{} of {} rows have no number in a required column (first: {})", left_out_,
                                           rows, first_left_out_);
      if (left_out_ * 100 > rows) {
        refuse(fmt::format("{}: {}; more than 1 % is too many", table_.name(), said));
      }
      flight_.notes.push_back(said + "; they are left out.");
    }
    if (repeated_ > 0) {
      flight_.notes.push_back(
          fmt::format("{} of {} rows repeat the one before them; they are left out.", repeated_, rows));
    }
    if (flight_.rows.empty()) {
      refuse(table_.name() + ": no rows after the header");
    }
  }

  const Table& table_;
  std::span<const FoundColumn> columns_;
  std::optional<std::size_t> phase_;
  std::optional<std::size_t> replayed_;
  std::vector<std::size_t> wrong_;  ///< cells of a column that nobody needs, with something that is no number
  Flight& flight_;
  std::size_t left_out_ = 0;
  std::size_t not_replayed_ = 0;
  std::size_t repeated_ = 0;
  std::string first_left_out_;
  std::size_t last_ = 0;  ///< row of the table that gave the last of the flight
};

// Control comes once in a flight, and is over with it. Only a reset leads from control to Safe, and from there back.
std::optional<std::size_t> second_flight(const std::vector<Row>& rows) {
  bool was_controlled = false;
  bool is_over = false;
  std::optional<std::size_t> anew;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const core::Phase phase = rows[i].phase;
    const bool is_control = phase == core::Phase::controlling;
    if (was_controlled && (phase == core::Phase::launched || (is_control && is_over))) {
      return anew.value_or(i);
    }
    if (is_control || phase == core::Phase::finished) {
      anew.reset();
    } else if (was_controlled && !anew) {
      anew = i;
    }
    was_controlled = was_controlled || is_control;
    is_over = is_over || (was_controlled && (phase == core::Phase::finished || phase == core::Phase::armed));
  }
  return {};
}

// What the phases of the rows tell; why they changed stands in no table. Nor does when, where it was in a hole.
void note_phases(Flight& flight) {
  const double usual_step_s =
      (flight.rows.back().time_s - flight.rows.front().time_s) / static_cast<double>(flight.rows.size());
  const double longest_step_s = std::max(0.1, 3.0 * usual_step_s);
  for (std::size_t i = 0; i < flight.rows.size(); ++i) {
    const auto [time_s, phase] = std::pair{flight.rows[i].time_s, flight.rows[i].phase};
    const core::Phase before = i == 0 ? core::Phase::safe : flight.rows[i - 1].phase;
    if (phase == before) {
      continue;
    }
    flight.phase_changes.push_back({time_s, phase, {}});
    if (i > 0 && time_s - flight.rows[i - 1].time_s <= longest_step_s) {  // one in the first row began before it
      if (auto* event = event_of(flight.events, phase)) {
        *event = time_s;
      }
    }
  }
}

}  // namespace

Flight read_flight_csv(const Table& table, const Reading& reading, const Needs& needs) {
  const FoundColumns columns{table, reading, needs};
  Flight flight;
  flight.known = {.plan = false, .saturation = columns.has("saturated")};
  flight.notes = columns.notes();
  Rows{table, columns, flight}.read_all();
  if (flight.known.phase) {
    if (const auto anew = second_flight(flight.rows)) {
      refuse(fmt::format(
          "{}: holds more than one flight: it begins anew at {:.3f} s, where the phase is {} after control; "
          "give each flight a table of its own",
          table.name(), flight.rows[*anew].time_s, core::name(flight.rows[*anew].phase)));
    }
    note_phases(flight);
  }
  return flight;
}

}  // namespace fantail::flight
