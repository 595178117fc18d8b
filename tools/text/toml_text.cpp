// SPDX-License-Identifier: MIT
#include "text/toml_text.hpp"

#include <fmt/core.h>

#include "text/error.hpp"
#include "text/printable.hpp"

namespace fantail::text {

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
      throw Error{
          ErrorKind::bad_configuration,
          fmt::format("\"{}\" is not text in UTF-8, which a TOML file must be; rename what is called so", text)};
    }
    rest.remove_prefix(length);
  }
  out += '"';
  return out;
}

}  // namespace fantail::text
