// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "logs/roll_log.hpp"
#include "logs/table.hpp"

namespace fantail::logs {

/// One column of a file and where its numbers go.
struct FoundColumn {
  std::size_t index;      ///< in the file
  std::string_view name;  ///< Fantail's
  std::vector<double> RollLog::* list;
  bool is_angle;
  bool needed;
};

/// time_s first. Throws sim::InputError as read_roll_log does.
[[nodiscard]] std::vector<FoundColumn> find_roll_columns(const Table& table, const Reading& reading,
                                                         const Needs& needs);

/// Where the words of the flight phase stand, if the file has them.
[[nodiscard]] std::optional<std::size_t> find_phase_column(const Table& table, const Reading& reading);

}  // namespace fantail::logs
