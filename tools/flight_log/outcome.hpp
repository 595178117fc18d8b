// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "protocol/log_tick.hpp"

namespace fantail::flight_log {

/// One value of a tick that came out otherwise, named as in the schema.
struct OutcomeDifference {
  std::string field;
  std::string recorded;
  std::string replayed;
};

/// Whether two ticks are the same bytes in a log.
[[nodiscard]] bool same_bytes(const protocol::LogTick& a, const protocol::LogTick& b);

/// The first value that differs, in the order of the schema; empty for ticks that are the same bytes.
[[nodiscard]] std::optional<OutcomeDifference> first_difference(const protocol::LogTick& recorded,
                                                                const protocol::LogTick& replayed);

}  // namespace fantail::flight_log
