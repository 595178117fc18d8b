// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identify/identification.hpp"
#include "identify/make_record.hpp"
#include "logs/roll_log.hpp"

namespace fantail::identify {

// What a person chooses in a word: a window, nodes, an axis of the grid.

/// By the log's events: "control", "thrust" and "coast" (the parts of control before and after burn-out), "step:N"
/// (from the N-th change of the reference under control, counted from 1, to the next), or "A:B" in seconds; either may
/// be left out. Throws text::Error: bad_configuration for a word that is none of these, bad_data when the log does
/// not say when that was.
[[nodiscard]] Window find_window(const logs::RollLog& log, const std::string& text);

/// Each of these windows; for none, "control", or all of a log that says nothing of control. Throws as find_window().
[[nodiscard]] std::vector<Window> find_windows(const logs::RollLog& log, const std::vector<std::string>& texts);

/// When the motor burnt out: from the log's summary, or where the axial specific force falls below zero for good.
[[nodiscard]] std::optional<double> burnout_s(const logs::RollLog& log);

/// Reads "0,5" (seconds), "even:N" (N intervals), "thrust:N,coast:M" (N even intervals until burn-out, M behind it) or
/// "auto". Times of what it returns are on the log's clock: nodes_in() puts them into a record. Throws text::Error:
/// bad_configuration for anything else; bad_data when burn-out does not lie inside the record, or the log does not know
/// it.
[[nodiscard]] NodeChoice find_nodes(const logs::RollLog& log, const model::Record& record, const std::string& text);

/// Nodes on the log's clock as identify() takes them: their times count from the begin of the record.
[[nodiscard]] NodeChoice nodes_in(const model::Record& record, const NodeChoice& on_clock);

/// Reads "FIRST:LAST:STEP": all above zero, last not below first, at most 1000 values. Empty for anything else.
[[nodiscard]] std::optional<model::Axis> parse_axis(const std::string& text);

}  // namespace fantail::identify
