// SPDX-License-Identifier: MIT
#include "text/encoding.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fantail::text {
namespace {

constexpr std::uint32_t replacement = 0xFFFD;

void append_utf8(std::string& out, std::uint32_t c) {
  const auto byte = [&out](std::uint32_t bits) { out += static_cast<char>(bits); };
  if (c < 0x80) {
    byte(c);
  } else if (c < 0x800) {
    byte(0xC0 | c >> 6);
    byte(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    byte(0xE0 | c >> 12);
    byte(0x80 | (c >> 6 & 0x3F));
    byte(0x80 | (c & 0x3F));
  } else {
    byte(0xF0 | c >> 18);
    byte(0x80 | (c >> 12 & 0x3F));
    byte(0x80 | (c >> 6 & 0x3F));
    byte(0x80 | (c & 0x3F));
  }
}

bool is_first_half(std::uint32_t unit) { return unit >= 0xD800 && unit < 0xDC00; }
bool is_second_half(std::uint32_t unit) { return unit >= 0xDC00 && unit < 0xE000; }

std::string of_utf16(std::string_view bytes, bool big_endian) {
  std::string out;
  out.reserve(bytes.size() / 2);
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const auto first = static_cast<unsigned char>(bytes[2 * i]);
    const auto second = static_cast<unsigned char>(bytes[2 * i + 1]);
    return big_endian ? first << 8U | second : second << 8U | first;
  };
  const std::size_t units = bytes.size() / 2;
  for (std::size_t i = 0; i < units; ++i) {
    const std::uint32_t one = unit(i);
    if (is_first_half(one) && i + 1 < units && is_second_half(unit(i + 1))) {
      append_utf8(out, 0x10000 + ((one - 0xD800) << 10U) + (unit(++i) - 0xDC00));
    } else {
      append_utf8(out, is_first_half(one) || is_second_half(one) ? replacement : one);
    }
  }
  if (bytes.size() % 2 != 0) {
    append_utf8(out, replacement);
  }
  return out;
}

/// No text of one byte a letter has a zero in each second one.
bool has_zeros_at(std::string_view bytes, std::size_t first) {
  constexpr std::size_t looked_at = 64;
  const std::size_t end = std::min(bytes.size(), looked_at);
  if (end < 4) {
    return false;
  }
  for (std::size_t i = 0; i < end; ++i) {
    if ((bytes[i] == '\0') != (i % 2 == first)) {
      return false;
    }
  }
  return true;
}

void use_newlines(std::string& text) {
  if (text.find('\r') == std::string::npos) {
    return;
  }
  std::size_t to = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') {
      continue;
    }
    text[to++] = text[i] == '\r' ? '\n' : text[i];
  }
  text.resize(to);
}

}  // namespace

std::string plain_text(std::string bytes) {
  const std::string_view all = bytes;
  if (all.starts_with("\xFF\xFE") || has_zeros_at(all, 1)) {
    bytes = of_utf16(all.substr(all.starts_with("\xFF\xFE") ? 2 : 0), false);
  } else if (all.starts_with("\xFE\xFF") || has_zeros_at(all, 0)) {
    bytes = of_utf16(all.substr(all.starts_with("\xFE\xFF") ? 2 : 0), true);
  } else if (all.starts_with("\xEF\xBB\xBF")) {
    bytes.erase(0, 3);
  }
  use_newlines(bytes);
  return bytes;
}

}  // namespace fantail::text
