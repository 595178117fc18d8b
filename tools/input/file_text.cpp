// SPDX-License-Identifier: MIT
#include "input/file_text.hpp"

#include "text/input_file.hpp"

namespace fantail::input {

std::optional<std::string> file_text(const std::string& file) {
  return text::read_if_there(file, text::InputKind::document);
}

}  // namespace fantail::input
