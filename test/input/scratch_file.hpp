// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "input/document.hpp"
#include "test.hpp"
#include "text/error.hpp"

namespace fantail::input {

/// A file that lives as long as the test; its name is the same for every test, so that messages can be compared.
class ScratchFile {
 public:
  explicit ScratchFile(std::string_view content, std::string_view name = "plan.toml")
      : folder_{std::filesystem::temp_directory_path() / ("fantail_test_" + std::to_string(::getpid()))},
        path_{folder_ / name} {
    std::filesystem::create_directories(folder_);
    std::ofstream{path_, std::ios::binary} << content;
  }
  ~ScratchFile() { std::filesystem::remove_all(folder_); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path folder_;
  std::filesystem::path path_;
};

struct Complaint {
  text::ErrorKind fault;
  std::string message;  ///< the folder of the scratch file taken off
};

/// What `action` is refused with; a failure of the test when it is not refused.
inline Complaint complaint(const std::function<void()>& action) {
  try {
    action();
  } catch (const text::Error& error) {
    std::string message = error.what();
    const std::size_t name = message.find("plan.toml");
    if (name != std::string::npos && message.starts_with('/')) {
      message.erase(0, name);
    }
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line: " << message;
    return {error.kind(), message};
  }
  ADD_FAILURE() << "was not refused";
  return {};
}

}  // namespace fantail::input
