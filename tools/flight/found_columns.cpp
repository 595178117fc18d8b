// SPDX-License-Identifier: MIT
#include "flight/found_columns.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/core.h>

#include "input/messages.hpp"
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
    found_.push_back({*index, &column, needed});
  } else if (must_be_there) {
    refuse_missing(column, name);
  }
}

void FoundColumns::refuse_missing(const Column& column, const std::string& name) const {
  std::string message = fmt::format("{}: {}", table_.name(), missing_column(name, table_.columns()));
  if (!reading_.options.empty()) {
    const std::string_view ours = column.is_true ? column.name.substr(5) : column.name;
    message += fmt::format("; if it has another name: {}column {}=NAME", reading_.options, ours);
    message += ours == "speed_m_s" ? "; if it was not measured: --speed" : "";
  }
  refuse(message);
}

}  // namespace fantail::flight
