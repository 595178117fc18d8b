// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "result/document.hpp"

namespace fantail::tool {

/// The command that was typed, this version, and the hashes of the files that the result is made from, as they are now:
/// to be called before long work. A folder stands for what fantail fly wrote into it. What is no file that can be read
/// has none.
[[nodiscard]] result::Made made_with(const std::vector<std::filesystem::path>& inputs,
                                     std::optional<std::uint64_t> seed = {}, std::vector<std::string> changes = {});

struct Delivery {
  std::filesystem::path folder{};
  std::string name{};                            ///< of its files, without an ending; empty: nothing is written
  std::string page{};                            ///< of its page, where it has another
  std::vector<std::filesystem::path> inputs{};   ///< files that no result may replace
  std::vector<std::string> removed{};            ///< files of an earlier result, which are none of these
  bool json = false;                             ///< on standard output, instead of text
  bool yes_is_required = false;                  ///< exit code 1 for every other answer
  std::vector<std::string> shown_files{"page"};  ///< "page", or the key of a spreadsheet: their paths end the text
  std::string last_line{};                       ///< of the text
  std::function<void()> when_written{};          ///< called when the files are there, before anything is printed
};

/// The end of a verb: writes result::files() into the folder, all or none, and prints text or JSON. Throws
/// text::OutputError, and RequirementNotMet where a yes is required and the answer is another.
void deliver(const result::Document& document, const Delivery& delivery);

}  // namespace fantail::tool
