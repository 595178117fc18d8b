// SPDX-License-Identifier: MIT
#include "logs/load_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "flight/column_texts.hpp"
#include "flight/columns.hpp"
#include "table_file/read.hpp"
#include "text/csv_cell.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"

namespace fantail::logs {
namespace {

constexpr std::array<std::string_view, 5> written_only{".mcap", ".ulg", ".lcmlog", ".json", ".xlsx"};

using table_file::Column;
using table_file::Kind;

// The shortest digits that give a number again; nothing where it is not known.
void add_cell(fmt::memory_buffer& out, const Column& column, double value) {
  if (std::isnan(value)) {
    return;
  }
  if (column.kind == Kind::word) {
    out.append(text::csv_cell(column.words[static_cast<std::size_t>(value)]));
  } else {
    fmt::format_to(std::back_inserter(out), "{}", value);
  }
}

flight::Table table_of(const table_file::Columns& columns, const std::string& name) {
  fmt::memory_buffer out;
  for (const Column& column : columns) {
    fmt::format_to(std::back_inserter(out), "{}{}", out.size() == 0 ? "" : ",", text::csv_cell(column.name));
  }
  const std::size_t rows = columns.empty() ? 0 : columns.front().values.size();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      out.push_back(i == 0 ? '\n' : ',');
      add_cell(out, columns[i], columns[i].values[row]);
    }
  }
  return flight::Table::parse(fmt::to_string(out), name, flight::Table::Rows::by_number);
}

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

}  // namespace

flight::Table load_table(const std::filesystem::path& file, const flight::Reading& reading) {
  const std::string name = file.string();
  const std::string ending = file.extension().string();
  if (ending == ".mat") {
    return table_of(table_file::read_mat(text::read_input(file), name,
                                         [&](std::string_view column) { return known_unit(column, reading); }),
                    name);
  }
  if (ending == ".parquet") {
    return table_of(table_file::read_parquet(text::read_input(file), name), name);
  }
  if (std::ranges::find(written_only, ending) != written_only.end()) {
    (void)text::InputFile{file};  // one that is missing is that first
    throw text::Error{
        text::ErrorKind::bad_data,
        fmt::format("{}: files that end in {} are not read as logs; allowed: .csv, .mat, .parquet and .ftl "
                    "(fantail log export writes the first three from the last)",
                    name, ending)};
  }
  return flight::Table::load(name);
}

}  // namespace fantail::logs
