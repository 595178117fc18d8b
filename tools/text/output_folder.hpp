// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace fantail::text
