// SPDX-License-Identifier: MIT
#include "logs/load_table.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "files/convert.hpp"
#include "flight/column_texts.hpp"
#include "flight/columns.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"

namespace fantail::logs {
namespace {

constexpr std::array<std::string_view, 2> written_only{".lcmlog", ".json"};

std::string in_radians(std::string unit) {
  return unit.starts_with("deg") ? "rad" + unit.substr(std::string_view{"deg"}.size()) : unit;
}

// Of a column of flight.csv, by that name.
std::optional<std::string> unit_of(std::string_view name, const flight::Reading& reading) {
  if (name != flight::phase_column && name != flight::replayed_column && flight::find_column(name) == nullptr) {
    return {};
  }
  if (const auto stated = reading.units.find(std::string{name}); stated != reading.units.end()) {
    return std::string{stated->second.name};
  }
  const std::string unit{flight::column_text(name).value_or(flight::ColumnText{.unit = "-", .description = {}}).unit};
  return reading.angles == flight::AngleUnit::radians ? in_radians(unit) : unit;
}

// Of a column of the file, if it will be asked for.
std::optional<std::string> known_unit(std::string_view name, const flight::Reading& reading) {
  for (const auto& [ours, theirs] : reading.columns) {
    if (theirs == name) {
      return unit_of(ours, reading);
    }
  }
  std::string ours{name};
  if (const std::size_t unit = ours.find("_rad");
      unit != std::string::npos && reading.angles == flight::AngleUnit::radians) {
    ours.replace(unit, 4, "_deg");
  }
  return unit_of(ours, reading);
}

// What is wanted and is no column must not be missed silently: a log without its roll angle is another log. Nor may a
// column that says its unit be read in another.
void require_wanted(const files::Read& read, const std::string& name, const flight::Reading& reading) {
  const auto refuse = [&](const std::string& complaint) {
    throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: {}", name, complaint)};
  };
  for (const auto& [column, kind] : read.not_columns) {
    if (known_unit(column, reading)) {
      refuse(
          fmt::format("{} is {}; a column is a vector of numbers, a cell of texts or a matrix of characters, as long "
                      "as the others",
                      column, kind));
    }
  }
  for (const auto& [column, said] : read.units) {
    const auto known = known_unit(column, reading);
    if (known && *known != "-" && said != *known) {
      refuse(fmt::format("units.{} is {}, and {} is read in {}", column, said, column, *known));
    }
  }
}

}  // namespace

flight::Table load_table(const std::filesystem::path& file, const flight::Reading& reading) {
  const std::string name = file.string();
  const std::string ending = file.extension().string();
  if (files::is_read(file)) {
    files::Read read = files::read(file);
    require_wanted(read, name, reading);
    return flight::Table::parse(std::move(read.csv), name, flight::Table::Rows::by_number);
  }
  if (std::ranges::find(written_only, ending) != written_only.end()) {
    (void)text::InputFile{file};  // one that is missing is that first
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: files that end in {} are not read as logs; allowed: .csv, .ftl, {}", name,
                                  ending, files::listed(files::read_endings))};
  }
  return flight::Table::load(name);
}

}  // namespace fantail::logs
