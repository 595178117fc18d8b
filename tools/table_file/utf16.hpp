// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fantail::table_file {

/// Bytes that are no UTF-8 become U+FFFD, one each.
[[nodiscard]] std::u16string utf16(std::string_view utf8);
/// Halves of a pair that stand alone become U+FFFD.
[[nodiscard]] std::string utf8(std::u16string_view utf16);

}  // namespace fantail::table_file
