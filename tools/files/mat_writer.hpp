// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Pieces of a MAT-file of version 5, which MATLAB, Octave and SciPy read (MathWorks, "MAT-File Format"). Each function
/// returns one array as the file has it; in a struct or in a cell it has no name.
namespace fantail::files::mat {

/// N x 1, of class double.
[[nodiscard]] std::string column(std::span<const double> values, std::string_view name = {});
/// 1 x N, of class char. Bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string text(std::string_view utf8, std::string_view name = {});
/// N x 1.
[[nodiscard]] std::string cell(std::span<const std::string> elements, std::string_view name = {});

struct Member {
  std::string name;                   ///< letters, digits and underscores; at most longest_name
  std::vector<std::string> elements;  ///< one for each struct of the array
};
/// `count` x 1 structs with the same members.
[[nodiscard]] std::string structs(std::size_t count, std::span<const Member> members, std::string_view name = {});

/// What MATLAB takes for a name.
inline constexpr std::size_t longest_name = 63;

/// The file with these arrays as its variables, each packed by zlib, which adds a checksum. It names no time: the same
/// arrays give the same bytes.
[[nodiscard]] std::string file(std::span<const std::string> variables);

}  // namespace fantail::files::mat
