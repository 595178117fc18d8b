// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace fantail::text {

/// The folder or a file in it could not be written. what() names the path and the system's reason.
class OutputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct NamedFile {
  std::string name;  ///< without folder
  std::string content;
};

/// A folder whose files appear together or not at all. Of several threads or processes that write into one folder at
/// once, one after the other does so, and the files of the last are there in the end.
class OutputFolder {
 public:
  /// `inputs`: what the results were made from; write() refuses to replace or remove such a file, or to write into such
  /// a folder.
  explicit OutputFolder(std::filesystem::path folder, std::vector<std::filesystem::path> inputs = {})
      : folder_{std::move(folder)}, inputs_{std::move(inputs)} {}

  /// Writes all files under temporary names, brings them to the disk, and only then gives them their names. Creates the
  /// folder. On any failure the temporaries and the folders it made are removed, an earlier result stays or comes back
  /// as it was, and OutputError is thrown. (Power lost between two renames can leave new files beside old ones.)
  /// Files with the names in `removed`, which are none of these, are gone afterwards.
  void write(std::span<const NamedFile> files, std::span<const std::string> removed = {}) const;

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> inputs_;
};

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
