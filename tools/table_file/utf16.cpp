// SPDX-License-Identifier: MIT
#include "table_file/utf16.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace fantail::table_file {
namespace {

constexpr char32_t replacement = 0xFFFD;
constexpr char32_t beyond_one_unit = 0x10000;

bool is_half(char32_t code) { return code >= 0xD800 && code < 0xE000; }

// The character at the front and how many bytes it has; none of it: the replacement, and one.
std::pair<char32_t, std::size_t> first_of(std::string_view utf8) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(utf8[i]); };
  const auto length = static_cast<std::size_t>(std::countl_one(byte(0)));
  if (length == 0) {
    return {byte(0), 1};
  }
  if (length < 2 || length > 4 || utf8.size() < length) {
    return {replacement, 1};
  }
  char32_t code = byte(0) & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (std::countl_one(byte(i)) != 1) {
      return {replacement, 1};
    }
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr char32_t least[] = {0x80, 0x800, beyond_one_unit};
  const bool ok = code >= least[length - 2] && code < 0x110000 && !is_half(code);
  return ok ? std::pair{code, length} : std::pair{replacement, std::size_t{1}};
}

void add(std::string& out, char32_t code) {
  const auto tail = [&](unsigned shift) { out += static_cast<char>(0x80U | (code >> shift & 0x3FU)); };
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0U | code >> 6U);
    tail(0);
  } else if (code < beyond_one_unit) {
    out += static_cast<char>(0xE0U | code >> 12U);
    tail(6);
    tail(0);
  } else {
    out += static_cast<char>(0xF0U | code >> 18U);
    tail(12);
    tail(6);
    tail(0);
  }
}

}  // namespace

std::u16string utf16(std::string_view utf8) {
  std::u16string out;
  while (!utf8.empty()) {
    const auto [code, size] = first_of(utf8);
    if (code < beyond_one_unit) {
      out += static_cast<char16_t>(code);
    } else {
      out += static_cast<char16_t>(0xD800 + ((code - beyond_one_unit) >> 10U));
      out += static_cast<char16_t>(0xDC00 + ((code - beyond_one_unit) & 0x3FFU));
    }
    utf8.remove_prefix(size);
  }
  return out;
}

std::string utf8(std::u16string_view utf16) {
  std::string out;
  for (std::size_t i = 0; i < utf16.size(); ++i) {
    char32_t code = utf16[i];
    if (code >= 0xD800 && code < 0xDC00 && i + 1 < utf16.size() && utf16[i + 1] >= 0xDC00 && utf16[i + 1] < 0xE000) {
      code = beyond_one_unit + ((code - 0xD800) << 10U) + (utf16[++i] - 0xDC00U);
    }
    add(out, is_half(code) ? replacement : code);
  }
  return out;
}

}  // namespace fantail::table_file
