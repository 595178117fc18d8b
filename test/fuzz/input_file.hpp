// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <unistd.h>

namespace fantail::fuzz {

/// A file for readers that take nothing else: in memory where there is such a folder, and gone when the program ends.
inline std::filesystem::path input_file(std::string_view bytes, const std::string& name) {
  namespace fs = std::filesystem;
  static const struct Folder {
    fs::path path = (fs::is_directory("/dev/shm") ? fs::path{"/dev/shm"} : fs::temp_directory_path()) /
                    ("fantail_fuzz_" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
  } folder;
  fs::path path = folder.path / name;
  std::ofstream{path, std::ios::binary}.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

}  // namespace fantail::fuzz
