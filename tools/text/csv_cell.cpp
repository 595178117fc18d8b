// SPDX-License-Identifier: MIT
#include "text/csv_cell.hpp"

namespace fantail::text {

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

}  // namespace fantail::text
