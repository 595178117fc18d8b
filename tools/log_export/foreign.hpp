// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flight_log/flight_log.hpp"
#include "log_export/source.hpp"

namespace fantail::log_export {

/// The columns of a log whose ticks are laid out as in another version of Fantail: its clock, then what its own schema
/// names, with the units as they stand there. Empty when the schema does not describe ticks.
[[nodiscard]] std::vector<std::string> foreign_fields(const flight_log::Flight& flight);

/// Such a log as a table; `names` are some of foreign_fields(). time_s is 0 at the first tick: what happened in the
/// flight only the other version knows. A value that a record is too short for is an empty cell.
[[nodiscard]] std::string foreign_csv(const flight_log::Flight& flight, std::span<const std::string> names,
                                      const Window& window);

}  // namespace fantail::log_export
