// SPDX-License-Identifier: MIT
#include "files/load.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "files/blue_raven.hpp"
#include "files/clocks.hpp"
#include "files/file_kind.hpp"
#include "files/tidy.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"

namespace fantail::files {
namespace {

void refuse_unnamed_velocities(const std::string& name, const Tidied& table) {
  std::size_t line = table.first_line;
  std::string_view names = table.text;
  for (; names.starts_with('#') && names.find('\n') != std::string_view::npos; ++line) {
    names.remove_prefix(names.find('\n') + 1);
  }
  names = names.substr(0, names.find('\n'));
  if (names.find("E3,W1 (rad/s)") != std::string_view::npos && names.find("Vx") == std::string_view::npos) {
    text::refuse(fmt::format(
        "{}:{}: RocketPy wrote this without variable names, so its header lacks the three velocities; name them: "
        "export_data(\"flight.csv\", \"altitude\", \"speed\", \"vz\", \"attitude_angle\", \"density\", "
        "time_step=0.01)",
        name, line));
  }
}

}  // namespace

Loaded parse(std::string text, const std::string& name) {
  if (auto raven = blue_raven_table(text)) {
    Loaded loaded{flight::Table::parse(std::move(raven->text), name, flight::Table::Rows::by_number)};
    loaded.notes = std::move(raven->notes);
    return loaded;
  }
  Tidied tidy = tidied(std::move(text));
  refuse_unnamed_velocities(name, tidy);
  Loaded loaded{flight::Table::parse(std::move(tidy.text), name, flight::Table::Rows::by_line, tidy.first_line)};
  loaded.notes = std::move(tidy.notes);
  if (auto one_clock = in_one_clock(loaded.table)) {
    loaded.table = flight::Table::parse(std::move(*one_clock), name, flight::Table::Rows::by_number);
    loaded.several_clocks = true;
    loaded.notes.emplace_back(
        "The file has a column of time for every few others: each was read with its own, and they are joined by time.");
  }
  return loaded;
}

Loaded load(const std::filesystem::path& file, Beside beside) {
  const std::string name = file.string();
  const std::string ending = file.extension().string();
  if (is_read(file)) {
    Read read = files::read(file);
    Loaded loaded{flight::Table::parse(std::move(read.csv), name, flight::Table::Rows::by_number)};
    loaded.notes = std::move(read.notes);
    loaded.several_clocks = ending == ".ulg" || loaded.table.find("IMU.AccX");
    loaded.units = std::move(read.units);
    loaded.not_columns = std::move(read.not_columns);
    return loaded;
  }
  const bool reads_logs = beside == Beside::ftl;
  if (ending == ".lcmlog" || ending == (reads_logs ? ".json" : ".ftl")) {
    (void)text::InputFile{file};  // one that is missing is that first
    text::refuse(fmt::format("{}: files that end in {} are not read as tables; allowed: CSV (any other ending){}, {}",
                             name, ending, reads_logs ? ", .ftl" : "", listed(read_endings)) +
                 (reads_logs ? "" : " (fantail log export writes CSV and some of these from an .ftl)"));
  }
  std::string bytes = text::read_input(file);
  if (const std::string kind = kind_that_is_no_table(bytes); !kind.empty()) {
    text::refuse(fmt::format("{}: cannot be read as a table: it is {}", name, kind));
  }
  return parse(std::move(bytes), name);
}

}  // namespace fantail::files
