// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>

namespace fantail::text {

/// The right to change the files of a folder, for one at a time of all threads and processes that ask for it, in
/// whatever container: a lock on a hidden file in it, which goes when the right is given back. Whoever ends, however,
/// gives it back.
class FolderLock {
 public:
  FolderLock() = default;
  ~FolderLock() { release(); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Waits until nobody else has it. Where no file can be made, or the file system knows no locks, there is none to
  /// wait for. Returns false when the folder has gone meanwhile. Throws OutputError when another has it for longer than
  /// `patience`.
  [[nodiscard]] bool take(const std::filesystem::path& folder, std::chrono::milliseconds patience);
  void release() noexcept;

 private:
  std::filesystem::path file_;
  int fd_ = -1;
};

}  // namespace fantail::text
