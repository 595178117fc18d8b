// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "faults/campaign.hpp"
#include "result/answer.hpp"

namespace fantail::faults {

/// Any cell red that no known limit excuses.
[[nodiscard]] bool has_red(const Result& result);

/// Any cell red for a known limit.
[[nodiscard]] bool has_red_limit(const Result& result);
/// Of a cell with a known limit: what a team has to do, and whether the rocket that was flown already does.
[[nodiscard]] std::string what_to_do(const CellResult& cell);

/// "safe", "RED", "a known limit", "not judged further".
[[nodiscard]] const char* word_of(Colour colour);

/// How many cells came to what, the worst first, with the flight that is farthest off.
[[nodiscard]] std::string headline(const Result& result);

/// What a person types to fly it, and one run of it alone.
[[nodiscard]] std::string command_of(const Campaign& campaign);
[[nodiscard]] std::string run_command(const Campaign& campaign, const Cell& cell, std::uint64_t number);

/// What one run came to, with why and what to do where a limit is known; `report` is its flight report.
[[nodiscard]] std::string run_text(const Alone& alone, const std::string& report);
[[nodiscard]] std::string run_json(const Campaign& campaign, const Alone& alone, const std::string& report,
                                   const std::string& version, const result::Made& made = {});

[[nodiscard]] std::string report_html(const Result& result, const std::string& version);
/// Is every cell safe? Undecided where one is not, for a limit that is known.
[[nodiscard]] result::Answer answer(const Result& result);
[[nodiscard]] result::Answer answer(Colour colour);
[[nodiscard]] std::string report_json(const Result& result, const std::string& version, const result::Made& made = {});
/// For the terminal: the headline, and every cell that is not green.
[[nodiscard]] std::string report_text(const Result& result);

}  // namespace fantail::faults
