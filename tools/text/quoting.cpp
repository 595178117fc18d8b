// SPDX-License-Identifier: MIT
#include "text/quoting.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <string_view>

#include <fmt/core.h>

#include "text/error.hpp"

namespace fantail::text {
namespace {

struct Form {
  unsigned char mask, lead;
  std::uint32_t smallest;  ///< what a shorter form could have said is not allowed
};
constexpr Form forms[]{{0x80, 0x00, 0}, {0xE0, 0xC0, 0x80}, {0xF0, 0xE0, 0x800}, {0xF8, 0xF0, 0x10000}};

}  // namespace

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r#") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  }
  return quoted + '"';
}

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

std::string toml_text(std::string_view text) {
  std::string out{'"'};
  for (std::string_view rest = text; !rest.empty();) {
    const char c = rest.front();
    std::size_t length = 1;
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    } else if (length = printable_character(rest); length > 0) {
      out += rest.substr(0, length);
    } else {
      throw Error{ErrorKind::bad_configuration,
                  fmt::format("\"{}\" is not UTF-8 text, which TOML needs; choose another name", text)};
    }
    rest.remove_prefix(length);
  }
  out += '"';
  return out;
}

std::size_t printable_character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  for (std::size_t length = 1; length <= 4; ++length) {
    const Form& form = forms[length - 1];
    if ((first & form.mask) != form.lead) {
      continue;
    }
    if (text.size() < length) {
      return 0;
    }
    std::uint32_t code = first & static_cast<unsigned char>(~form.mask);
    for (std::size_t i = 1; i < length; ++i) {
      const auto next = static_cast<unsigned char>(text[i]);
      if ((next & 0xC0U) != 0x80U) {
        return 0;
      }
      code = (code << 6U) | (next & 0x3FU);
    }
    const bool surrogate = code >= 0xD800 && code < 0xE000;
    const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    return code >= form.smallest && code < 0x110000 && !surrogate && !control ? length : 0;
  }
  return 0;
}

std::string printable(std::string_view text) {
  // Whoever gives a word of 4000 characters need not read it whole, twice.
  constexpr std::size_t longest = 3000;
  constexpr std::size_t kept_at_the_end = 900;
  if (text.size() > longest) {
    return printable(text.substr(0, longest - kept_at_the_end)) + " ... " +
           printable(text.substr(text.size() - kept_at_the_end));
  }
  std::string result;
  while (!text.empty()) {
    const std::size_t length = printable_character(text);
    result += length == 0 ? std::string_view{"?"} : text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

}  // namespace fantail::text
