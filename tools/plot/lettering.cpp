// SPDX-License-Identifier: MIT
#include "plot/lettering.hpp"

#include "report/escape.hpp"
#include "report/numbers.hpp"

namespace fantail::plot {
namespace {

constexpr std::string_view narrow = "iljftrI.,:;'|!()[] /";
constexpr std::string_view wide = "mwMW@%<>&+=~";

bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }  // UTF-8

double letter_width(char c) {
  if (narrow.find(c) != std::string_view::npos) {
    return 4.5;
  }
  if (wide.find(c) != std::string_view::npos) {
    return 11.7;
  }
  return c >= 'A' && c <= 'Z' ? 8.8 : 7.6;
}

}  // namespace

double text_width(std::string_view text) {
  double width = 0.0;
  for (const char c : text) {
    width += begins_letter(c) ? letter_width(c) : 0.0;
  }
  return width;
}

std::string shortened(std::string_view text, double width) {
  if (text_width(text) <= width) {
    return std::string{text};
  }
  constexpr double ellipsis = 11.0;
  double used = ellipsis;
  std::size_t end = 0;
  while (end < text.size()) {
    used += letter_width(text[end]);
    if (used > width) {
      break;
    }
    do {
      ++end;
    } while (end < text.size() && !begins_letter(text[end]));
  }
  return std::string{text.substr(0, end)} + "\u2026";
}

std::string printed(std::string_view text) { return report::with_minus(report::escape_html(text)); }

}  // namespace fantail::plot
