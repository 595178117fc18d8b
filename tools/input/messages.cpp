// SPDX-License-Identifier: MIT
#include "input/messages.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

namespace fantail::input {
namespace {

// Number of single-letter edits between two words.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string plain_number(double value) {
  std::array<char, 32> text{};
  const std::string exact{text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
  const std::string rounded{
      text.data(), std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 12).ptr};
  return rounded.size() + 2 < exact.size() ? rounded : exact;
}

std::string about(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr};
}

std::optional<std::string> suggestion(std::string_view wrong, std::span<const std::string> known) {
  std::optional<std::string> best;
  std::size_t nearest = std::max<std::size_t>(2, wrong.size() / 3) + 1;
  for (const std::string& word : known) {
    const bool part = wrong.size() >= 3 && (word.find(wrong) != std::string::npos);
    const std::size_t d = part ? std::min<std::size_t>(2, distance(wrong, word)) : distance(wrong, word);
    if (d < nearest) {
      nearest = d;
      best = word;
    }
  }
  return best;
}

}  // namespace fantail::input
