// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace fantail::text {

/// To the minute, by the clock of this PC, with its distance from UTC: "2026-11-28 14:08 UTC+0100".
[[nodiscard]] std::string local_minute(std::chrono::system_clock::time_point time);

}  // namespace fantail::text
