// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/loggers.hpp"
#include "files/quantities.hpp"

namespace fantail::files {

/// Which column of a file holds a quantity, as somebody has said it: axial=-Ay:m/s2.
struct Source {
  Quantity quantity{};
  std::string_view name{};     ///< by which it was asked for, among known_quantities()
  std::string column{};        ///< its name in the file
  const Unit* unit = nullptr;  ///< of the column; null: nobody stated one, or it holds words
  double factor = 1.0;         ///< value * factor + offset is in SI and radians: sign, scale and unit
  double offset = 0.0;
  std::optional<double> no_value{};  ///< in the file, where there is no number
  bool must_be_there = true;
  std::string words{};  ///< behind the =, as it was said
};
using Sources = std::vector<Source>;

/// "time=ts:s,axial=-Ay:m/s2,height=0.3048*alt:m": QUANTITY=[-][SCALE*]COLUMN:UNIT, several with commas between, of the
/// quantities that are asked for. A quantity that is called as Fantail's own column, with its unit (roll_rate_deg_s),
/// may do without a unit. A name may contain colons itself, a unit none.
///
/// `option` is named in messages. Throws text::Error (bad_configuration) for an unknown quantity or unit, one that is
/// missing or of another dimension (naming those allowed), a scale outside 1e-12 to 1e12, a reversed time, a
/// quantity twice.
[[nodiscard]] Sources parse_columns(std::string_view text, const std::string& option, std::span<const Quantity> asked);

/// The older way: "roll_rate_deg_s=gyro_x", where all behind the = is the name and no unit is stated.
[[nodiscard]] Source parse_column(std::string_view text, const std::string& option, std::span<const Quantity> asked);

/// The columns of a logger: all but time and axial need not be there.
[[nodiscard]] Sources sources_of(const Logger& logger, std::span<const Quantity> asked);

/// What both say, and where they disagree the first.
[[nodiscard]] Sources merged(const Sources& first, const Sources& second);
[[nodiscard]] const Source* find(const Sources& sources, Quantity quantity);

/// "time is t in ms, roll_rate is p in rad/s".
[[nodiscard]] std::string in_words(const Sources& sources);

// What was said is kept beside a log, in LOG.columns.toml: table columns, roll_rate = "p:rad/s".

[[nodiscard]] std::filesystem::path kept_sources_file(const std::filesystem::path& log);
/// Throws as parse_columns() does, with file and line, and text::Error (bad_data) for a file that is not TOML.
[[nodiscard]] Sources read_sources(const std::filesystem::path& file, std::span<const Quantity> asked);
[[nodiscard]] std::string sources_toml(const Sources& sources, const std::string& log);

}  // namespace fantail::files
