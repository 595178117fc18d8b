// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "figures.hpp"

// What is held of a sentence whose words are free.
namespace fantail::sil {

/// One word, of a device, a key or a quantity.
inline bool says(std::string_view sentence, std::string_view word) {
  return sentence.find(word) != std::string_view::npos;
}

/// These numbers, one behind the other.
inline bool tells(std::string_view sentence, const std::vector<std::string>& numbers) {
  const std::vector<std::string> all = figures(sentence);
  return !std::ranges::search(all, numbers).empty();
}

}  // namespace fantail::sil
