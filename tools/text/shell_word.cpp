// SPDX-License-Identifier: MIT
#include "text/shell_word.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace fantail::text {

std::string shell_word(const std::string& word) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view{"._-+=:/,"}.find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, is_plain)) {
    return word;
  }
  std::string all = "'";
  for (const char c : word) {
    all += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return all + "'";
}

}  // namespace fantail::text
