// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "flight/flight.hpp"
#include "report/figures.hpp"

namespace fantail::report {

/// A clause of a verdict: "the roll is not known at all times under control", or the hold error is not, for another
/// reason than a reset. Empty: both are, or the hold error never is.
[[nodiscard]] std::string_view what_misses_control(const flight::Flight& flight, const Figures& figures);

/// "the reference or the fin offset": for want of it the hold error is not known at some rows under control.
[[nodiscard]] std::string what_hold_lacks(const HoldRecord& hold);

/// Sentences with a space before each: " The roll is not known from 3.00 s to 5.00 s.", and where what is known begins
/// after control has, ends before control or apogee, or is thin; likewise of the hold error, where the roll is known.
/// Not of resets. Empty: nothing is missing.
[[nodiscard]] std::string unknown_roll(const flight::Flight& flight, const Figures& figures);

/// Nobody knows how such a flight went on: neither the end of control nor apogee is on record.
[[nodiscard]] bool ends_under_control(const flight::Flight& flight, const Figures& figures);

}  // namespace fantail::report
