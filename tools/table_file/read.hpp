// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "table_file/column.hpp"

namespace fantail::table_file {

/// Which columns a reader asks for: the unit that goes with a name, nothing for a name that it does not know.
using KnownUnit = std::function<std::optional<std::string>(std::string_view name)>;

/// The columns of a MAT-file (version 5: save -v7 and -v6): the members of its struct `flight`, or of the only struct
/// that has columns, or its variables. A column is a vector of numbers, a cell of texts or a matrix of characters;
/// single values beside them are not used; where `flight` has nothing longer, they are columns of one row. Where a
/// struct `words` has a cell of that name, numbers are places in it, from 1 on.
///
/// `name` is what messages call the file. Throws text::Error (bad_data): damaged, none of these, no columns or several
/// sets of them, two variables of one name, columns of unequal length; under a name that is `known` something else than
/// a column; a struct `units` that says another unit for a column than `known` does.
[[nodiscard]] Columns read_mat(std::string_view file, const std::string& name, const KnownUnit& known);

/// The columns of a Parquet file as Fantail writes it: flat, plain, packed with gzip or not at all. Throws text::Error
/// (bad_data): damaged, no Parquet; packed or encoded otherwise, saying how to write it for Fantail.
[[nodiscard]] Columns read_parquet(std::string_view file, const std::string& name);

}  // namespace fantail::table_file
