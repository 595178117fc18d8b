// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace fantail::files {

/// Seconds of a time of day, "12:34:56.789", or of a date with one behind it, "2026-03-01 12:34:56" or with a T, and Z
/// or nothing at its end: from 1970 on with a date, else from midnight. A decimal comma is one. Empty for what is none
/// of these, and for hours, minutes, seconds, months or days that no clock and no calendar has.
[[nodiscard]] std::optional<double> clock_time_s(std::string_view text);

}  // namespace fantail::files
