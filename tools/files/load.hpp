// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "files/convert.hpp"
#include "flight/table.hpp"

namespace fantail::files {

/// Who wrote a CSV file, and so how it is read.
enum class Writer : std::uint8_t {
  ours,      ///< or one with our layout: as it stands
  logger,    ///< the header may stand behind a '#', as AltosUI writes it, where no other stands before the first row
  simulator  ///< likewise, the last comment with a cell "Time", as OpenRocket and RocketPy write it
};

struct Loaded {
  // NOLINTNEXTLINE(google-explicit-constructor): a table is one of which no more is known
  Loaded(flight::Table of) : table{std::move(of)} {}

  flight::Table table;
  std::vector<std::string> notes{};  ///< a sentence each: damage that was read around
  /// Its columns have their numbers in different rows: it is several tables, sorted into one by time, as the topics of
  /// a ULog are.
  bool several_clocks = false;
  Read::Pairs units{};        ///< what the file says, by the names of columns
  Read::Pairs not_columns{};  ///< a name, and what stands under it instead of a column
};

/// The text of a CSV file, which messages call `name`. Of others' files the cells may be separated by semicolons or
/// tabs, a name that comes again is NAME.1, NAME.2, and a last line that is cut off is left out, with a note; each row
/// stays on its line. The decimal point is a point.
///
/// Throws text::Error (bad_data) as flight::Table::parse() does, for a semicolon or tab beside commas, and for what
/// RocketPy exports when no variable is named: its header then lacks three columns, and it is unknown which number is
/// which.
[[nodiscard]] Loaded parse(std::string text, const std::string& name, Writer writer);

/// The table in a file: of the kinds that other programs write (files/convert.hpp) their columns, of every other a CSV
/// file's. Throws as parse() and read() do, and text::Error (bad_data) for exports that are not read, by the ends of
/// their names.
[[nodiscard]] Loaded load(const std::filesystem::path& file, Writer writer);

}  // namespace fantail::files
