// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// What a test holds of a sentence, so that its words are free.
namespace fantail {

using Numbers = std::vector<std::string>;

/// The numbers of a sentence as they stand in it, with sign and decimals: what a test holds of it, so that its words
/// are free. A digit within a name (tasha3) is none, and a minus between two numbers (3-4) is a dash.
inline Numbers figures(std::string_view sentence) {
  const auto at = [&](std::size_t i) { return i < sentence.size() ? static_cast<unsigned char>(sentence[i]) : 0; };
  const auto is_digit = [&](std::size_t i) { return std::isdigit(at(i)) != 0; };
  Numbers found;
  for (std::size_t i = 0; i < sentence.size();) {
    const bool is_in_a_word = i > 0 && (std::isalnum(at(i - 1)) != 0 || at(i - 1) == '_' || at(i - 1) == '.');
    const std::size_t digit = i + (at(i) == '-' ? 1 : 0);
    if (is_in_a_word || !is_digit(digit)) {
      ++i;
      continue;
    }
    std::size_t end = digit;
    while (is_digit(end) || (at(end) == '.' && is_digit(end + 1))) {
      ++end;
    }
    found.emplace_back(sentence.substr(i, end - i));
    i = end;
  }
  return found;
}

/// These numbers, one behind the other.
inline bool tells(std::string_view sentence, const Numbers& numbers) {
  const Numbers all = figures(sentence);
  return !std::ranges::search(all, numbers).empty();
}

/// One word that any wording has: of a device, a key or a quantity.
inline bool says(std::string_view sentence, std::string_view word) {
  return sentence.find(word) != std::string_view::npos;
}

}  // namespace fantail
