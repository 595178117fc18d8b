// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "manual/command.hpp"

namespace CLI {
class Option;
}  // namespace CLI
namespace fantail::tool {

/// What CLI11 has no place for of an option.
struct Declared {
  std::string allowed{};
  std::vector<std::string> words{};
  manual::Offering offering{};
  std::function<std::vector<std::string>()> values{};  ///< as the variable is now; of a flag that is given an empty one
  std::vector<std::string> usual{};
  bool changes_result = false;
  bool belongs_to_command = false;
  bool hidden = false;
};

/// Of the program whose command line is read.
[[nodiscard]] Declared& declared(const CLI::Option* option);
/// Another program may have its options at the same addresses.
void forget_declared();

}  // namespace fantail::tool
