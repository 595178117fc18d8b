// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace fantail::listen {

struct PageFolder {
  std::filesystem::path folder{};
  std::string remark{};  ///< why it is not named after the log alone, a sentence; empty where it is
};

/// Where the page of a log goes: into `under`, by the log's name without folder and ending, unless the page of another
/// file is there. Then with _2 behind it, _3 ... The folder that has a page of this file already is the one to
/// overwrite. A page that does not say whose it is counts as another file's.
[[nodiscard]] PageFolder page_folder(const std::filesystem::path& under, const std::filesystem::path& log);

}  // namespace fantail::listen
