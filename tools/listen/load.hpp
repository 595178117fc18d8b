// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flight/table.hpp"
#include "listen/imu_log.hpp"

namespace fantail::listen {

/// The text of a CSV file as a header and rows that flight::Table reads, each row still on its line: a header behind a
/// '#', which AltosUI writes, is one where no other stands before the first row of numbers; a name that comes again is
/// NAME.1, NAME.2. A last line that is cut off is left out, and `notes` says so.
[[nodiscard]] std::string tidy(std::string text, std::vector<std::string>& notes);

struct Loaded {
  flight::Table table;
  std::vector<std::string> notes{};  ///< a sentence each: damage that was read around
  Clocks clocks = Clocks::one;
};

/// The table in a log of another program (files/convert.hpp), else in CSV through tidy(). Throws as files::read() does,
/// and text::Error (bad_data) for other kinds of log, by the ends of their names.
[[nodiscard]] Loaded load(const std::filesystem::path& file);

}  // namespace fantail::listen
