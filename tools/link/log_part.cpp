// SPDX-License-Identifier: MIT
#include "link/log_part.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "text/output_folder.hpp"

namespace fantail::link {

LogPart::LogPart(std::filesystem::path path) : path_{std::move(path)} {
  std::error_code error;
  if (path_.has_parent_path()) {
    std::filesystem::create_directories(path_.parent_path(), error);
  }
  if (error) {
    throw text::OutputError{path_.parent_path().string() + ": " + error.message()};
  }
  open(std::ios::app);
  const std::streamoff end = file_.seekp(0, std::ios::end).tellp();
  if (end < 0) {
    fail();
  }
  size_ = static_cast<std::uint32_t>(end);
}

void LogPart::fail() const { throw text::OutputError{path_.string() + ": " + std::strerror(errno)}; }

void LogPart::open(std::ios::openmode mode) {
  file_.close();
  file_.clear();
  errno = 0;
  file_.open(path_, std::ios::binary | mode);
  if (!file_) {
    fail();
  }
}

std::vector<std::byte> LogPart::read(std::uint32_t offset, std::uint32_t size) const {
  std::vector<char> text(size);
  std::ifstream file{path_, std::ios::binary};
  file.seekg(offset);
  if (!file.read(text.data(), static_cast<std::streamsize>(size))) {
    throw text::OutputError{path_.string() + ": what was downloaded cannot be read back"};
  }
  std::vector<std::byte> bytes(size);
  std::ranges::transform(text, bytes.begin(), [](char c) { return static_cast<std::byte>(c); });
  return bytes;
}

void LogPart::append(std::span<const std::byte> bytes) {
  std::vector<char> text(bytes.size());
  std::ranges::transform(bytes, text.begin(), [](std::byte b) { return static_cast<char>(b); });
  errno = 0;
  if (!file_.write(text.data(), static_cast<std::streamsize>(text.size())).flush()) {
    fail();
  }
  size_ += static_cast<std::uint32_t>(bytes.size());
}

void LogPart::start_anew() {
  open(std::ios::trunc);
  size_ = 0;
}

void LogPart::remove() {
  file_.close();
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace fantail::link
