// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fantail::manual {

/// What stands between each "<!-- manual -->" and the "<!-- end of manual -->" that follows it. Throws
/// std::runtime_error when there is none.
[[nodiscard]] std::string passages_for_manual(std::string_view page);

/// Headings, paragraphs, lists, tables and code of our Markdown as roff. A row of a table is an item: its first cell is
/// the tag, its last cell the text, and those between stand behind the tag. Of a link only the words are left.
[[nodiscard]] std::string roff_of_markdown(std::string_view text);

}  // namespace fantail::manual
