// SPDX-License-Identifier: MIT
#include "logs/column_map.hpp"

#include <algorithm>
#include <optional>

#include <fmt/core.h>

#include "flight/columns.hpp"
#include "flight/named_source.hpp"
#include "flight/units.hpp"
#include "input/document.hpp"
#include "input/messages.hpp"
#include "input/section.hpp"
#include "text/error.hpp"

namespace fantail::logs {
namespace {

using text::Error;
using text::ErrorKind;

constexpr const char* table_name = "columns";

[[noreturn]] void refuse(const std::string& where, const std::string& complaint) {
  throw Error{ErrorKind::bad_configuration, where + ": " + complaint};
}

std::vector<std::string> quantity_names() {
  std::vector<std::string> names{std::string{flight::phase_column}};
  for (const flight::Column& column : flight::columns()) {
    if (!column.is_true) {
      names.emplace_back(flight::quantity_of(column.name).name);
    }
  }
  return names;
}

// The column of flight.csv that is called so, with its unit or without.
std::optional<std::string_view> column_called(std::string_view word) {
  if (word == flight::phase_column) {
    return flight::phase_column;
  }
  for (const flight::Column& column : flight::columns()) {
    if (!column.is_true && (word == column.name || word == flight::quantity_of(column.name).name)) {
      return column.name;
    }
  }
  return {};
}

// "p:rad/s", behind "roll_rate=".
MappedColumn mapped(const std::string& where, const std::string& word, const std::string& source) {
  const auto ours = column_called(word);
  if (!ours) {
    flight::refuse_unknown_quantity(where, word, quantity_names());
  }
  const auto dimension = flight::quantity_of(*ours).dimension;
  if (!dimension) {
    return {.ours = std::string{*ours}, .theirs = source, .unit = {}};
  }
  const auto [column, unit] = flight::column_in_unit(where, word, source, *dimension);
  return {.ours = std::string{*ours}, .theirs = column, .unit = std::string{unit->name}};
}

void add(ColumnMap& map, const std::string& where, MappedColumn column) {
  if (std::ranges::find(map, column.ours, &MappedColumn::ours) != map.end()) {
    refuse(where, "the quantity appears twice");
  }
  map.push_back(std::move(column));
}

}  // namespace

ColumnMap parse_column_map(std::string_view text, const std::string& option) {
  ColumnMap map;
  for (const auto& [where, quantity, source] : flight::named_sources(text, option, "time=t:ms,roll_rate=p:rad/s")) {
    add(map, where, mapped(where, quantity, source));
  }
  return map;
}

ColumnMap read_column_map(const std::filesystem::path& file) {
  const input::Document document = input::Document::load(file.string());
  input::refuse_unknown_sections(document, std::vector<std::string>{table_name});
  input::Section section{document, table_name};
  ColumnMap map;
  for (const std::string& word : document.root()[table_name].keys()) {
    const std::string source = section.text(word);
    add(map, section.where(word), mapped(section.where(word), word, source));
  }
  return map;
}

std::string column_map_toml(const ColumnMap& map, const std::string& log) {
  std::string text = fmt::format("# How Fantail reads {}: the name and the unit of each column in that file.\n[{}]\n",
                                 log, table_name);
  for (const MappedColumn& column : map) {
    std::string source = column.theirs + (column.unit.empty() ? "" : ":" + column.unit);
    for (std::size_t at = 0; (at = source.find_first_of("\\\"", at)) != std::string::npos; at += 2) {
      source.insert(at, 1, '\\');
    }
    text += fmt::format("{} = \"{}\"\n", flight::quantity_of(column.ours).name, source);
  }
  return text;
}

std::filesystem::path column_map_file(const std::filesystem::path& log) { return log.string() + ".columns.toml"; }

ColumnMap merged(const ColumnMap& first, const ColumnMap& second) {
  ColumnMap map = first;
  for (const MappedColumn& column : second) {
    if (std::ranges::find(map, column.ours, &MappedColumn::ours) == map.end()) {
      map.push_back(column);
    }
  }
  return map;
}

std::string column_map_words(const ColumnMap& map) {
  std::string words;
  for (const auto& [ours, theirs, unit] : map) {
    words += fmt::format("{}{} is {}{}", words.empty() ? "" : ", ", flight::quantity_of(ours).name, theirs,
                         unit.empty() ? "" : " in " + unit);
  }
  return words;
}

void apply_map(const ColumnMap& map, flight::Reading& reading) {
  for (const auto& [ours, theirs, unit] : map) {
    if (reading.columns.contains(ours)) {
      continue;
    }
    reading.columns[ours] = theirs;
    if (const flight::Unit* const known = flight::find_unit(unit)) {
      reading.units.emplace(ours, *known);
    }
  }
}

std::string apply_map_beside(const std::filesystem::path& log, flight::Reading& reading) {
  const std::filesystem::path file = column_map_file(log);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    return {};
  }
  const ColumnMap map = read_column_map(file);
  apply_map(map, reading);
  return fmt::format("Columns as {} says, where no option says otherwise: {}.", file.filename().string(),
                     column_map_words(map));
}

}  // namespace fantail::logs
