// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "table_file/column.hpp"

namespace fantail::table_file {

/// The columns of a MAT-file (version 5: save -v7 and -v6): the members of its struct `flight`, or of the only struct
/// that has columns, or its variables. A column is a vector of numbers, a cell of texts or a matrix of characters;
/// single values beside them are not used. Where a struct `words` has a cell of that name, numbers are places in it,
/// from 1 on.
///
/// `name` is what messages call the file. Throws text::Error (bad_data): damaged, none of these, no columns or several
/// sets of them, columns of unequal length.
[[nodiscard]] Columns read_mat(std::string_view file, const std::string& name);

/// The columns of a Parquet file as Fantail writes it: flat, plain, packed with gzip or not at all. Throws text::Error
/// (bad_data): damaged, no Parquet; packed or encoded otherwise, saying how to write it for Fantail.
[[nodiscard]] Columns read_parquet(std::string_view file, const std::string& name);

}  // namespace fantail::table_file
