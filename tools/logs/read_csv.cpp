// SPDX-License-Identifier: MIT
#include "logs/read_csv.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "files/rows.hpp"
#include "flight/columns.hpp"
#include "text/error.hpp"

namespace fantail::logs {
namespace {

using flight::Flight;

constexpr std::string_view true_prefix = "true_";

bool is_needed(files::Quantity quantity, const Needs& needs) {
  switch (quantity) {
    case files::Quantity::time: return true;
    case files::Quantity::roll_angle: return needs.roll_angle;
    case files::Quantity::roll_rate: return needs.roll_rate;
    case files::Quantity::canard: return needs.canard;
    case files::Quantity::speed: return needs.speed;
    default: return false;
  }
}

// A true_ column is one of the quantity that it is the truth of.
const files::KnownQuantity& quantity_of(const flight::Column& column) {
  return *files::of_own_column(column.is_true ? column.name.substr(true_prefix.size()) : column.name);
}

// "roll_rate_rad_s" of "roll_rate_deg_s", "rad/s" of "deg/s".
std::string in_radians(std::string_view name, std::string_view degrees, std::string_view radians) {
  const std::size_t unit = name.find(degrees);
  std::string text{name};
  return unit == std::string::npos ? text : text.replace(unit, degrees.size(), radians);
}

/// Which columns of a table are those of a flight.
class FoundColumns {
 public:
  FoundColumns(const files::Loaded& file, const Reading& reading, const Needs& needs)
      : file_{file}, table_{file.table}, reading_{reading} {
    const std::span<const flight::Column> all = flight::columns();
    for (const flight::Column& column : all) {
      if (!column.is_true) {
        find(column, is_needed(quantity_of(column).quantity, needs));
      }
    }
    for (const flight::Column& column : all) {
      if (column.is_true && std::ranges::find(columns_, &column) == columns_.end()) {
        add(column, std::string{column.name}, nullptr, false, false);
      }
    }
    if (found_.size() == 1) {
      std::string message = fmt::format("{}: no column besides time_s is known; known columns are:", table_.name());
      std::ranges::for_each(all.subspan(1), [&](const auto& column) { message += fmt::format(" {}", column.name); });
      text::refuse(message);
    }
    const files::Source* const named = files::find(reading.columns, files::Quantity::phase);
    phase_ = place(named == nullptr ? std::string{flight::phase_column} : named->column, {});
    if (named != nullptr && !phase_) {
      text::refuse(fmt::format("{}: {}", table_.name(), flight::missing_column(named->column, table_.columns())));
    }
    replayed_ = place(std::string{flight::replayed_column}, {});
  }

  [[nodiscard]] std::optional<std::size_t> phase() const { return phase_; }
  [[nodiscard]] std::optional<std::size_t> replayed() const { return replayed_; }
  /// Two lists of one length, the time first.
  [[nodiscard]] const std::vector<files::Found>& found() const { return found_; }
  [[nodiscard]] const std::vector<const flight::Column*>& columns() const { return columns_; }
  [[nodiscard]] bool has(std::string_view name) const {
    return std::ranges::any_of(columns_, [&](const flight::Column* column) { return column->name == name; });
  }

  /// What a person may not expect: a sentence each.
  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> sentences;
    for (const files::Source& source : reading_.columns) {
      const auto dimension = files::known(source.quantity).dimension;
      if (dimension && source.unit == nullptr && !are_radians(*dimension)) {
        sentences.push_back(fmt::format("No unit was stated for {}; it is read in {}.", source.column,
                                        files::own_unit(*dimension).name));
      }
    }
    constexpr std::size_t most_shown = 8;
    std::string unused;
    std::size_t count = 0;
    for (std::size_t i = 0; i < table_.columns().size(); ++i) {
      const bool is_used =
          phase_ == i || replayed_ == i || std::ranges::find(found_, i, &files::Found::column) != found_.end();
      if (!is_used && !table_.columns()[i].empty() && ++count <= most_shown) {
        unused += (unused.empty() ? "" : ", ") + flight::in_quotes(table_.columns()[i]);
      }
    }
    if (count > 0) {
      sentences.push_back(fmt::format("Columns that are not used: {}{}.", unused,
                                      count > most_shown ? fmt::format(" and {} more", count - most_shown) : ""));
    }
    return sentences;
  }

 private:
  [[nodiscard]] bool are_radians(files::Dimension dimension) const {
    return reading_.angles == AngleUnit::radians &&
           (dimension == files::Dimension::angle || dimension == files::Dimension::angular_rate);
  }

  // What is wanted and is no column must not be missed silently: a log without its roll angle is another log. Nor may a
  // column that says its unit be read in another.
  [[nodiscard]] std::optional<std::size_t> place(const std::string& name, const std::string& unit) const {
    for (const auto& [column, kind] : file_.not_columns) {
      if (column == name) {
        text::refuse(
            fmt::format("{}: {} is {}; a column is a vector of numbers, a cell of texts or a matrix of characters, "
                        "as long as the others",
                        table_.name(), column, kind));
      }
    }
    for (const auto& [column, said] : file_.units) {
      if (column == name && !unit.empty() && said != unit) {
        text::refuse(
            fmt::format("{}: units.{} is {}, and {} is read in {}", table_.name(), column, said, column, unit));
      }
    }
    return table_.find(name);
  }

  // Where the truth is asked for, a column with a name that the person has given is the true one.
  void find(const flight::Column& measured, bool needed) {
    const flight::Column* const truth =
        reading_.truth ? flight::find_column(fmt::format("true_{}", measured.name)) : nullptr;
    const flight::Column& column = truth != nullptr ? *truth : measured;
    if (const files::Source* const source = files::find(reading_.columns, quantity_of(measured).quantity)) {
      add(column, source->column, source, true, needed);
      return;
    }
    add(column, std::string{column.name}, nullptr, needed, needed);
    if (truth != nullptr) {
      add(measured, std::string{measured.name}, nullptr, false, false);
    }
  }

  void add(const flight::Column& column, const std::string& name, const files::Source* source, bool must_be_there,
           bool needed) {
    const files::KnownQuantity& quantity = quantity_of(column);
    files::Found found{.needed = needed, .is_flag = column.unit == flight::Column::Unit::flag};
    std::string unit;
    if (quantity.dimension) {
      const files::Source* const stated = files::find(reading_.columns, quantity.quantity);
      const bool is_stated = stated != nullptr && stated->unit != nullptr;
      const files::Unit& in = is_stated ? *stated->unit : files::own_unit(*quantity.dimension);
      const bool radians = !is_stated && are_radians(*quantity.dimension);
      unit = radians ? in_radians(in.name, "deg", "rad") : in.name;
      found.factor = radians ? 1.0 : in.si;
      if (is_stated && source != nullptr) {
        found.factor = source->factor;
        found.offset = source->offset;
      }
    }
    auto index = place(name, unit);
    if (!index && reading_.angles == AngleUnit::radians) {
      index = place(in_radians(name, "_deg", "_rad"), unit);
    }
    if (index) {
      found.column = *index;
      found_.push_back(found);
      columns_.push_back(&column);
    } else if (must_be_there) {
      refuse_missing(quantity, name);
    }
  }

  [[noreturn]] void refuse_missing(const files::KnownQuantity& quantity, const std::string& name) const {
    std::string message = fmt::format("{}: {}", table_.name(), flight::missing_column(name, table_.columns()));
    if (!reading_.options.empty()) {
      message += fmt::format("; if it has another name: {}columns {}=NAME:UNIT", reading_.options, quantity.name);
      message += quantity.quantity == files::Quantity::speed ? "; if it was not measured, give --speed" : "";
    }
    text::refuse(message);
  }

  const files::Loaded& file_;
  const flight::Table& table_;
  const Reading& reading_;
  std::vector<files::Found> found_;
  std::vector<const flight::Column*> columns_;
  std::optional<std::size_t> phase_;
  std::optional<std::size_t> replayed_;
};

void read_all(const flight::Table& table, const FoundColumns& columns, Flight& flight) {
  const files::Rows rows = files::read_rows(table, columns.found(), {.only_where = columns.replayed()});
  flight.rows.assign(rows.rows.size(), flight::unknown_row());
  for (std::size_t c = 0; c < rows.values.size(); ++c) {
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
      if (!std::isnan(rows.values[c][i])) {
        columns.columns()[c]->set(flight.rows[i], rows.values[c][i]);
      }
    }
  }
  if (columns.phase()) {
    read_phases(table, rows, *columns.phase(), flight);
  }
  if (rows.not_used > 0) {
    flight.notes.push_back(fmt::format("{} of {} rows belong to ticks that could not be replayed; they are left out.",
                                       rows.not_used, table.rows()));
  }
  flight.notes.insert(flight.notes.end(), rows.notes.begin(), rows.notes.end());
  if (flight.rows.empty()) {
    text::refuse(table.name() + ": no rows after the header");
  }
  for (std::size_t c = 0; c < rows.lost.size(); ++c) {
    if (rows.lost[c].words > 0) {
      flight.notes.push_back(fmt::format(
          "{} of {} cells of {} contain {}; they are treated as unknown.", rows.lost[c].words, table.rows(),
          table.columns()[columns.found()[c].column],
          columns.found()[c].is_flag ? "neither 0 nor 1, nor a word for them" : "text instead of a number"));
    }
  }
}

/// The columns of a logger that many people have, where nobody names any. Of one that may sit any way round nothing is
/// read that has a direction.
Reading with_map(const flight::Table& table, const Reading& reading, std::vector<std::string>& notes) {
  const files::Logger* const logger =
      reading.columns.empty() && !table.find("time_s") ? files::logger_of(table.columns()) : nullptr;
  if (logger == nullptr) {
    return reading;
  }
  std::vector<files::Quantity> all;
  for (const files::KnownQuantity& known : files::known_quantities()) {
    all.push_back(known.quantity);
  }
  constexpr std::array without_direction{files::Quantity::time, files::Quantity::height, files::Quantity::speed};
  Reading with = reading;
  for (const files::Source& source : files::sources_of(*logger, all)) {
    const bool is_of_a_flight = std::ranges::find(files::of_flight_csv, source.quantity) != files::of_flight_csv.end();
    const bool has_direction = std::ranges::find(without_direction, source.quantity) == without_direction.end();
    if (is_of_a_flight && table.find(source.column) && !(logger->any_mounting && has_direction)) {
      with.columns.push_back(source);
    }
  }
  notes.push_back(
      fmt::format("Columns of the map {}, which fits them: {}.", logger->name, files::in_words(with.columns)));
  if (!logger->doubt.empty()) {
    notes.emplace_back(logger->doubt);
  }
  return with;
}

}  // namespace

std::string follow_kept_sources(const std::filesystem::path& log, Reading& reading) {
  const std::filesystem::path file = files::kept_sources_file(log);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    return {};
  }
  const files::Sources kept = files::read_sources(file, files::of_flight_csv);
  reading.columns = files::merged(reading.columns, kept);
  return fmt::format("Columns from {}, except where an option names them: {}.", file.filename().string(),
                     files::in_words(kept));
}

flight::Flight read_flight_csv(const files::Loaded& file, const Reading& reading, const Needs& needs) {
  const flight::Table& table = file.table;
  Flight flight;
  const Reading mapped = with_map(table, reading, flight.notes);
  const FoundColumns columns{file, mapped, needs};
  flight.known = {.plan = false, .saturation = columns.has("saturated")};
  flight.known.phase = false;
  std::ranges::copy(columns.notes(), std::back_inserter(flight.notes));
  read_all(table, columns, flight);
  note_phases(flight, table.name());
  return flight;
}

}  // namespace fantail::logs
