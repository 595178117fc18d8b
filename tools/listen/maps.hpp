// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "listen/columns.hpp"

namespace fantail::listen {

/// The columns of a logger that many people have.
struct Map {
  std::string_view name;
  std::string_view about;
  std::string_view columns;  ///< as parse_columns() takes them; all but time and axial may be missing in a log
  /// A log whose columns include all of these, with commas between, is one of these where nobody says otherwise.
  std::string_view known_by;
};

[[nodiscard]] std::span<const Map> maps();
[[nodiscard]] const Map* find_map(std::string_view name);
/// The map of a log with these columns; null when it is none of them.
[[nodiscard]] const Map* map_of(std::span<const std::string> columns);

/// The sources of a map.
[[nodiscard]] Sources sources_of(const Map& map);

}  // namespace fantail::listen
