// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "listen/heard.hpp"
#include "result/document.hpp"

namespace fantail::listen {

/// Was the launch detected in time, and nothing else taken for one? Undecided where the log has no launch, or doubts.
[[nodiscard]] result::Document answer(const Heard& heard, const result::Made& made);
/// Every figure in its JSON, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_fields();
/// The flight over time, a section for each quantity that the log or the law has.
[[nodiscard]] std::vector<result::Section> charts(const Heard& heard);

struct PageFolder {
  std::filesystem::path folder{};
  std::string remark{};  ///< why it is not named after the log alone, a sentence; empty where it is
};
/// Where the page of a log goes: into `under`, by the log's name without folder and ending, unless the page of another
/// file is there. Then with _2 behind it, _3 ... The folder that has a page of this file already is the one to
/// overwrite. A page that does not say whose it is counts as another file's.
[[nodiscard]] PageFolder page_folder(const std::filesystem::path& under, const std::filesystem::path& log);

}  // namespace fantail::listen
