// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "logs/roll_log.hpp"

namespace fantail::identify {

/// A stretch of a log by its clock, both ends included.
struct Window {
  std::optional<double> from_s{};  ///< empty: from the first sample
  std::optional<double> to_s{};
  std::string name{};
};

/// By the log's events: "control", "thrust" and "coast" (the parts of control before and after burn-out), "step:N"
/// (from the N-th change of the reference under control, counted from 1, to the next), or "A:B" in seconds; either may
/// be left out. Throws sim::InputError: bad_configuration for a word that is none of these, bad_data when the log does
/// not say when that was.
[[nodiscard]] Window find_window(const logs::RollLog& log, const std::string& text);

/// When the motor burnt out: from the log's summary, or where the axial specific force falls below zero for good.
[[nodiscard]] std::optional<double> burnout_s(const logs::RollLog& log);

}  // namespace fantail::identify
