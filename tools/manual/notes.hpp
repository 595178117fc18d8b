// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fantail::manual {

struct Example {
  std::string command;
  std::string meaning;  ///< may be empty
};

/// What the help of a command has below its options, taken apart.
struct Notes {
  std::vector<std::string> sentences{};
  std::vector<std::string> exits{};  ///< "Exit code 0: go; 1: no go."
  std::vector<Example> examples{};
};

/// Lines that begin with two spaces are commands, with their meaning behind two spaces or more, or on the next line
/// far to the right; those with a few spaces more go on with a command. Other lines are sentences.
[[nodiscard]] Notes notes_of(std::string_view text);

}  // namespace fantail::manual
