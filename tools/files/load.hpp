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

/// What its reader can read beside tables, for messages.
enum class Beside : std::uint8_t {
  ftl,     ///< flight logs of Fantail: whoever asks has looked for one before
  nothing  ///< tables alone
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

/// The text of a CSV file, which messages call `name`, as files::tidied() makes a table of it.
///
/// Throws text::Error (bad_data) as flight::Table::parse() does, and for what RocketPy exports when no variable is
/// named: its header then lacks three columns, and it is unknown which number is which.
[[nodiscard]] Loaded parse(std::string text, const std::string& name);

/// The table in a file: of the kinds that other programs write (files/convert.hpp) their columns, of every other a CSV
/// file's. Throws as parse() and read() do, and text::Error (bad_data) for exports that are not read, by the ends of
/// their names.
[[nodiscard]] Loaded load(const std::filesystem::path& file, Beside beside);

}  // namespace fantail::files
