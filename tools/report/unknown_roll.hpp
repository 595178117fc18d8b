// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "flight/flight.hpp"
#include "report/figures.hpp"

namespace fantail::report {

/// A clause of a verdict on such a flight.
inline constexpr std::string_view roll_is_unknown = "the roll is not known at all times under control";

/// Is that so, for another reason than a reset?
[[nodiscard]] bool misses_control(const flight::Flight& flight, const Figures& figures);

/// Sentences with a space before each: " The roll is not known from 3.00 s to 5.00 s.", and where what is known begins
/// after control has, ends before control or apogee, or is thin. Not of resets. Empty: nothing is missing.
[[nodiscard]] std::string unknown_roll(const flight::Flight& flight, const Figures& figures);

/// Nobody knows how such a flight went on: neither the end of control nor apogee is on record.
[[nodiscard]] bool ends_under_control(const flight::Flight& flight, const Figures& figures);

}  // namespace fantail::report
