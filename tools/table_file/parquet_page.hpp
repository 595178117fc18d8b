// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "table_file/column.hpp"
#include "table_file/parquet_format.hpp"

namespace fantail::table_file::parquet {

/// Why a page was not read. Empty: it was.
struct PageFault {
  std::string complaint{};
  bool is_damage = true;  ///< or it is in a form that Fantail does not read
};

/// Reads the pages of one column, each with a header and values.
class PageReader {
 public:
  struct Form {
    Type type;
    Codec codec;
    bool optional;      ///< values may be missing
    bool without_sign;  ///< integers
  };

  explicit PageReader(const Form& form) : form_{form} {}

  /// Takes the page at the front of `rest` and adds its values. `most` is how many bytes it may have unpacked, and
  /// gets less by what it has.
  [[nodiscard]] PageFault read(std::string_view& rest, Column& column, std::size_t& most) const;

 private:
  [[nodiscard]] PageFault add(std::string_view content, std::size_t count, Column& column) const;

  Form form_;
};

}  // namespace fantail::table_file::parquet
