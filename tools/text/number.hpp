// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fantail::text {

/// `text` without spaces and tabs at its ends, and without carriage returns at its end.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The finite number that `text` is, spaces around it allowed; empty for anything else, "nan" and "1,5" too.
[[nodiscard]] std::optional<double> number(std::string_view text);

/// What a cell of an on/off column says: 1, true and yes, or 0, false and no, in whatever letters and with spaces
/// around them. Empty for anything else.
[[nodiscard]] std::optional<bool> flag(std::string_view text);

/// The whole number from 0 on that `text` is, with no sign and nothing else.
[[nodiscard]] std::optional<std::uint64_t> whole_number(std::string_view text);

/// "-7.30" for (-7.3, 2); never "-0.0". Not a number reads "not a number"; beyond 1e15 it is "1.234e+20".
[[nodiscard]] std::string fixed(double value, int decimals);

/// The same with no trailing zeros after the point: "6", "-7.3".
[[nodiscard]] std::string brief(double value, int decimals);

/// "1 run", "3 runs": a number with what it counts. `many` is empty where an s makes it.
[[nodiscard]] std::string counted(std::uint64_t number, std::string_view one, std::string_view many = {});

/// For print, a number or a sentence with numbers: a hyphen is half as wide as a minus and gets lost before a large
/// figure.
[[nodiscard]] std::string with_minus(std::string_view text);

/// The number that all of `text` is, as std::from_chars reads it: no sign but a minus, no spaces, no locale. "inf" and
/// "nan" may be numbers. The nearest double, on every platform; empty for what a double cannot hold.
[[nodiscard]] std::optional<double> decimal(std::string_view text);

}  // namespace fantail::text
