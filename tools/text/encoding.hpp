// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fantail::text {

/// A text that somebody else's program has written, as UTF-8 without a mark in front and with lines that end in one
/// newline: of UTF-16 with a mark, or whose every second byte is zero at its beginning; of lines that end as on Windows
/// or on an old Macintosh. Half a character becomes U+FFFD. Other bytes stay as they are.
[[nodiscard]] std::string plain_text(std::string bytes);

}  // namespace fantail::text
