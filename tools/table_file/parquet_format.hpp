// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "text/deflate.hpp"

/// What is used of Apache Parquet's parquet.thrift: numbers of fields and values of enumerations.
namespace fantail::table_file::parquet {

inline constexpr std::string_view magic = "PAR1";  // at both ends of a file

enum class Type : std::int8_t { boolean = 0, int32 = 1, int64 = 2, float32 = 4, float64 = 5, bytes = 6 };
enum class Repetition : std::int8_t { required = 0, optional = 1 };
enum class Codec : std::int8_t { none = 0, gzip = 2 };
enum class Encoding : std::int8_t { plain = 0, rle = 3 };
inline constexpr int data_page = 0;
inline constexpr int utf8_text = 0;  // a converted type

namespace file_fields {
inline constexpr int version = 1, schema = 2, rows = 3, row_groups = 4, key_values = 5, created_by = 6;
}
namespace schema_fields {
inline constexpr int type = 1, repetition = 3, name = 4, children = 5, converted_type = 6, logical_type = 10;
}
namespace key_value_fields {
inline constexpr int key = 1, value = 2;
}
namespace row_group_fields {
inline constexpr int columns = 1, bytes = 2, rows = 3;
}
namespace chunk_fields {
inline constexpr int file_offset = 2, about = 3;
}
namespace column_fields {
inline constexpr int type = 1, encodings = 2, path = 3, codec = 4, values = 5, bytes_unpacked = 6, bytes_packed = 7,
                     data_offset = 9, dictionary_offset = 11;
}
namespace page_fields {
inline constexpr int type = 1, bytes_unpacked = 2, bytes_packed = 3, crc = 4, data = 5;
}
namespace data_page_fields {
inline constexpr int values = 1, encoding = 2, definition_encoding = 3, repetition_encoding = 4;
}

/// Parquet has a checksum for its values and none for what describes them. Fantail's own stands under this key: of the
/// description from its begin to the key itself.
inline constexpr std::string_view checksum_key = "fantail.crc32";
[[nodiscard]] inline std::string checksum_of(std::string_view description, std::size_t key_at) {
  return std::to_string(text::crc32(description.substr(0, key_at)));
}

}  // namespace fantail::table_file::parquet
