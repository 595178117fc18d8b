// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "table_file/column.hpp"

namespace fantail::table_file::parquet {

/// A Parquet file: one row group, plain values packed with gzip, a checksum on each page. What is unknown is null.
/// Words are texts. `about` stands under the key "fantail" of the file's metadata.
[[nodiscard]] std::string file(const Columns& columns, const std::string& about);

}  // namespace fantail::table_file::parquet
