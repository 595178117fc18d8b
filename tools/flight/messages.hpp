// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fantail::flight {

/// A piece of a file for a message: in quotes, of bearable length, without the characters that move a terminal.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// "no column roll_angle_deg (did you mean roll_deg?); there are: time_s, roll_deg".
[[nodiscard]] std::string missing_column(std::string_view wanted, std::span<const std::string> there);

}  // namespace fantail::flight
