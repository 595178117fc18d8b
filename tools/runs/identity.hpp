// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fantail::runs {

/// What makes many flights these and no others, in the order of their names: "seed", "7". "file" does not: the same
/// scenario may lie elsewhere on another machine.
using Identity = std::vector<std::pair<std::string, std::string>>;

/// The first that `one` says otherwise than `other`, with where they are: "seed is 7 there and 8 here". Empty when both
/// say the same.
[[nodiscard]] std::string difference(const Identity& one, std::string_view where, const Identity& other,
                                     std::string_view where_other);

/// An identity's text, a line, and back. The second throws json::Error for what is none.
[[nodiscard]] std::string identity_json(const Identity& identity);
[[nodiscard]] Identity parse_identity(std::string_view json);

/// So much of a digest as tells two apart, where a person may have to read it: 16 digits.
[[nodiscard]] std::string short_digest(std::string_view content);

}  // namespace fantail::runs
