// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fantail::table_file::mat {

/// A MAT-file that is damaged, or none; what() says where.
class Damage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A variable of a MAT-file or a part of one. What a table cannot be made of (sparse and complex numbers, objects,
/// functions, arrays of structs) has a name, a size and no content.
struct Array {
  enum class Content : std::uint8_t { nothing, numbers, text, cell, structure };

  std::string name;
  Content content = Content::nothing;
  std::size_t rows = 0;
  std::size_t columns = 0;           ///< of more than two dimensions all but the first
  std::string_view kind{};           ///< of no content, what it is instead: "complex numbers"
  std::vector<double> numbers{};     ///< one column behind the other
  std::vector<std::string> lines{};  ///< of a text: one for each row, without the spaces that fill it up
  std::vector<Array> elements{};     ///< of a cell; of a single struct its members, with their names
};

/// All variables of a file of version 5, packed or not, as MATLAB and Octave write it with -v6 and -v7. Throws Damage.
[[nodiscard]] std::vector<Array> read_arrays(std::string_view file);

}  // namespace fantail::table_file::mat
