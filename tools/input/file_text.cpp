// SPDX-License-Identifier: MIT
#include "input/file_text.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "text/error.hpp"

namespace fantail::input {

std::optional<std::string> file_text(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    return std::nullopt;
  }
  std::ifstream stream{file, std::ios::binary};
  std::string text{std::istreambuf_iterator<char>{stream}, {}};
  if (!stream.is_open()) {
    throw text::Error{text::ErrorKind::bad_data, file + ": cannot be read"};
  }
  return text;
}

}  // namespace fantail::input
