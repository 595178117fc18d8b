// SPDX-License-Identifier: MIT
#include "flight/found_columns.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/core.h>

#include "input/messages.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"

namespace fantail::flight {
namespace {

using text::ErrorKind;

[[noreturn]] void refuse(const std::string& message) { throw text::Error{ErrorKind::bad_data, message}; }

struct NeededColumn {
  std::string_view name;
  bool Needs::* need;
};
constexpr std::array needed_columns{
    NeededColumn{"roll_angle_deg", &Needs::roll_angle}, NeededColumn{"roll_rate_deg_s", &Needs::roll_rate},
    NeededColumn{"canard_deg", &Needs::canard}, NeededColumn{"speed_m_s", &Needs::speed}};

bool is_needed(std::string_view name, const Needs& needs) {
  return std::ranges::any_of(needed_columns, [&](const auto& c) { return c.name == name && needs.*c.need; });
}

void refuse_unknown_names(const Reading& reading) {
  std::vector<std::string> names{std::string{phase_column}};
  for (const Column& column : columns()) {
    if (!column.is_true) {
      names.emplace_back(column.name);
    }
  }
  for (const auto& [ours, theirs] : reading.columns) {
    if (std::ranges::find(names, ours) != names.end()) {
      continue;
    }
    std::string message =
        fmt::format("{}column {}={}: unknown column {}", reading.options, ours, theirs, in_quotes(ours));
    if (const auto meant = input::suggestion(ours, names)) {
      message += "; did you mean " + *meant + "?";
    }
    message += " Fantail's columns:";
    std::ranges::for_each(names, [&](const std::string& name) { message += " " + name; });
    throw text::Error{ErrorKind::bad_configuration, message};
  }
}

constexpr std::string_view true_prefix = "true_";
constexpr std::size_t most_unused_shown = 8;

// What flight.csv has it in: the first unit of a dimension.
std::string_view base_unit(Dimension dimension) {
  return std::ranges::find(units(), dimension, &Unit::dimension)->name;
}

// What the file itself would call a column in radians.
std::string in_radians(std::string name) {
  const std::size_t unit = name.find("_deg");
  return unit == std::string::npos ? name : name.replace(unit, 4, "_rad");
}

}  // namespace

FoundColumns::FoundColumns(const Table& table, const Reading& reading, const Needs& needs)
    : table_{table}, reading_{reading} {
  refuse_unknown_names(reading);
  const std::span<const Column> all = columns();
  for (const Column& column : all) {
    if (!column.is_true) {
      find(column, &column == all.data() || is_needed(column.name, needs));
    }
  }
  for (const Column& column : all) {
    if (column.is_true && std::ranges::find(found_, &column, &FoundColumn::column) == found_.end()) {
      add(column, std::string{column.name}, false, false);
    }
  }
  if (found_.size() == 1) {
    std::string message = fmt::format("{}: no column besides time_s is known; known columns are:", table.name());
    std::ranges::for_each(all.subspan(1), [&](const Column& column) { message += fmt::format(" {}", column.name); });
    refuse(message);
  }
}

bool FoundColumns::has(std::string_view name) const {
  return std::ranges::any_of(found_, [&](const FoundColumn& found) { return found.column->name == name; });
}

std::optional<std::size_t> FoundColumns::phase() const {
  const auto named = reading_.columns.find(std::string{phase_column});
  return named == reading_.columns.end() ? table_.find(phase_column) : table_.column(named->second);
}

// Where the truth is asked for, a column with a name that the person has given is the true one.
void FoundColumns::find(const Column& measured, bool needed) {
  const Column* const truth = reading_.truth ? find_column(fmt::format("true_{}", measured.name)) : nullptr;
  const Column& column = truth != nullptr ? *truth : measured;
  if (const auto named = reading_.columns.find(std::string{measured.name}); named != reading_.columns.end()) {
    add(column, named->second, true, needed);
    return;
  }
  add(column, std::string{column.name}, needed, needed);
  if (truth != nullptr) {
    add(measured, std::string{measured.name}, false, false);
  }
}

void FoundColumns::add(const Column& column, std::string name, bool must_be_there, bool needed) {
  if (reading_.angles == AngleUnit::radians && !table_.find(name) && table_.find(in_radians(name))) {
    name = in_radians(name);
  }
  if (const auto index = table_.find(name)) {
    found_.push_back({*index, &column, needed, si_of(column)});
  } else if (must_be_there) {
    refuse_missing(column, name);
  }
}

// A true_ column is measured in the unit of the column that it is the truth of.
double FoundColumns::si_of(const Column& column) const {
  const std::string_view measured = column.is_true ? column.name.substr(true_prefix.size()) : column.name;
  if (const auto unit = reading_.units.find(std::string{measured}); unit != reading_.units.end()) {
    return unit->second.si;
  }
  return column.unit == Column::Unit::degrees && reading_.angles == AngleUnit::degrees ? text::radians(1.0) : 1.0;
}

std::vector<std::string> FoundColumns::notes() const {
  std::vector<std::string> sentences;
  for (const auto& [ours, theirs] : reading_.columns) {
    const Quantity quantity = quantity_of(ours);
    const bool by_option = ours.find("_deg") != std::string::npos && reading_.angles == AngleUnit::radians;
    if (quantity.dimension && !by_option && !reading_.units.contains(ours)) {
      sentences.push_back(
          fmt::format("No unit was stated for {}; it is read in {}.", theirs, base_unit(*quantity.dimension)));
    }
  }
  std::string unused;
  std::size_t count = 0;
  for (std::size_t i = 0; i < table_.columns().size(); ++i) {
    const bool used = phase() == i || table_.find(replayed_column) == i ||
                      std::ranges::find(found_, i, &FoundColumn::index) != found_.end();
    if (!used && !table_.columns()[i].empty() && ++count <= most_unused_shown) {
      unused += (unused.empty() ? "" : ", ") + in_quotes(table_.columns()[i]);
    }
  }
  if (count > 0) {
    sentences.push_back(fmt::format(
        "Columns that are not used: {}{}.", unused,
        count > most_unused_shown ? fmt::format(" and {} more", count - most_unused_shown) : std::string{}));
  }
  return sentences;
}

void FoundColumns::refuse_missing(const Column& column, const std::string& name) const {
  std::string message = fmt::format("{}: {}", table_.name(), missing_column(name, table_.columns()));
  if (!reading_.options.empty()) {
    const std::string_view ours = column.is_true ? column.name.substr(true_prefix.size()) : column.name;
    message +=
        fmt::format("; if it has another name: {}columns {}=NAME:UNIT", reading_.options, quantity_of(ours).name);
    message += ours == "speed_m_s" ? "; if it was not measured: --speed" : "";
  }
  refuse(message);
}

}  // namespace fantail::flight
