// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "flight/read_csv.hpp"
#include "flight/table.hpp"

namespace fantail::logs {

/// The table in a file: of the kinds that other programs write (files/convert.hpp) their columns, of every other a CSV
/// file's. `reading` says which columns will be asked for, and in which units. Throws as flight::Table::load() and
/// files::read() do, and text::Error (bad_data) for exports that are not read, by the ends of their names.
[[nodiscard]] flight::Table load_table(const std::filesystem::path& file, const flight::Reading& reading);

}  // namespace fantail::logs
