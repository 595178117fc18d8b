// SPDX-License-Identifier: MIT
#include "fantail/node_flash.hpp"

#include <stdexcept>

#include "text/output_folder.hpp"

namespace fantail::tool {

std::unique_ptr<hal::on_linux::FileFlash> open_node_flash(const std::filesystem::path& file) {
  if (file.has_parent_path()) {
    std::error_code ignored;  // the file itself says what is wrong
    std::filesystem::create_directories(file.parent_path(), ignored);
  }
  try {
    return std::make_unique<hal::on_linux::FileFlash>(file);
  } catch (const std::runtime_error& error) {
    throw text::OutputError{error.what()};
  }
}

}  // namespace fantail::tool
