// SPDX-License-Identifier: MIT
#include "report/card_text.hpp"

#include <algorithm>

#include "text/printable.hpp"

namespace fantail::report {
namespace {

constexpr std::string_view ellipsis = " \u2026";

/// Of UTF-8, as text::printable() leaves it.
std::string_view first_character(std::string_view text) {
  std::size_t end = text.empty() ? 0 : 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
    end += 1;
  }
  return text.substr(0, end);
}

/// In parts of the size of the font.
double width_of(std::string_view character) {
  constexpr std::string_view narrow = " !'()*,-./:;IJ[\\]fijlrt|";
  constexpr std::string_view wide = "#%&+<=>@MW^mw~";
  if (character.size() > 1) {
    return 1.2;
  }
  const char c = character.front();
  if (narrow.find(c) != std::string_view::npos) {
    return c == '*' ? 0.5 : 0.42;
  }
  return wide.find(c) != std::string_view::npos ? 1.0 : (c >= 'A' && c <= 'Z' ? 0.79 : 0.64);
}

/// As much of the beginning as fits, one character at least.
std::string_view fitting(std::string_view text, const Letters& letters, double most_width) {
  std::size_t end = first_character(text).size();
  while (end < text.size()) {
    const std::size_t next = end + first_character(text.substr(end)).size();
    if (width(text.substr(0, next), letters) > most_width) {
      break;
    }
    end = next;
  }
  return text.substr(0, end);
}

}  // namespace

double width(std::string_view text, const Letters& letters) {
  double whole = 0.0;
  while (!text.empty()) {
    const std::string_view character = first_character(text);
    whole += width_of(character);
    text.remove_prefix(character.size());
  }
  return whole * letters.size * (letters.bold ? 1.17 : 1.0);
}

std::vector<std::string> in_lines(std::string_view text, const Letters& letters, double most_width,
                                  std::size_t most_lines) {
  const std::string clean = text::printable(text);
  std::string_view rest = clean;
  std::vector<std::string> lines{""};
  while (!rest.empty()) {
    const std::size_t space = rest.find(' ');
    const std::string_view word = fitting(rest.substr(0, space), letters, most_width);
    std::string longer = lines.back() + (lines.back().empty() ? "" : " ");
    longer += word;
    if (!lines.back().empty() && width(longer, letters) > most_width) {
      if (lines.size() == most_lines) {
        const bool is_endless = word.size() < std::min(space, rest.size());
        const double left = most_width - width(ellipsis, letters);
        lines.back() = std::string{fitting(is_endless ? longer : lines.back(), letters, left)} + std::string{ellipsis};
        return lines;
      }
      longer = word;
      lines.emplace_back();
    }
    lines.back() = longer;
    rest.remove_prefix(std::min(rest.size(), space == word.size() ? space + 1 : word.size()));
  }
  return lines;
}

bool needs_another_font(std::string_view text) {
  for (std::string_view rest = text; !rest.empty(); rest.remove_prefix(first_character(rest).size())) {
    const std::string_view character = first_character(rest);
    const bool is_indic = character.size() == 3 && character >= "\u0900" && character < "\u0E80";
    const bool is_east_asian = character.size() == 3 && character >= "\u2E80" && character < "\uFB00";
    if (is_indic || is_east_asian || (character.size() == 4 && character >= "\U00020000")) {
      return true;
    }
  }
  return false;
}

}  // namespace fantail::report
