// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "files/quantities.hpp"

namespace fantail::files {

/// A logger that many people have.
struct Logger {
  std::string_view name;
  std::string_view about;  ///< a noun phrase without an article
  /// As parse_columns() takes them; all but time and axial may be missing in a log. Without axial: it has no
  /// accelerometer, or its file does not hold it.
  std::string_view columns;
  /// A log whose columns include all of these, with commas between, is one of these where nobody says otherwise.
  std::string_view known_by;
  std::optional<double> no_value{};  ///< what it writes where it has no number
  std::string_view lacks{};          ///< columns that another has with the same names, with commas between
  std::string_view doubt{};          ///< what a reader must not take for measured, a sentence
  bool any_mounting = false;         ///< its axes are those of its board, which may sit any way round
  bool in_order = false;             ///< the columns of known_by stand in this order
};
[[nodiscard]] std::span<const Logger> loggers();
[[nodiscard]] const Logger* find_logger(std::string_view name);
/// The logger of a table with these columns; null when it is none of them.
[[nodiscard]] const Logger* logger_of(std::span<const std::string> columns);
[[nodiscard]] bool has_axial(const Logger& logger);

/// What a table is that holds no log of an accelerometer, and how it is of use, a clause. Empty: not known.
[[nodiscard]] std::string use_without_axial(std::span<const std::string> columns);

}  // namespace fantail::files
