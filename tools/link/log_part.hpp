// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <vector>

namespace fantail::link {

/// What has been downloaded so far, in a file that outlives this program. It holds whole, verified bytes only, in
/// order; a program that is killed can leave it shorter, and never wrong. Every call throws text::OutputError with
/// the path and the system's reason.
class LogPart {
 public:
  /// Goes on with the file that is there; makes its folder.
  explicit LogPart(std::filesystem::path path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] std::vector<std::byte> read(std::uint32_t offset, std::uint32_t size) const;
  void append(std::span<const std::byte> bytes);
  void start_anew();
  /// When it is no longer needed.
  void remove();

 private:
  void open(std::ios::openmode mode);
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::ofstream file_;
  std::uint32_t size_ = 0;
};

}  // namespace fantail::link
