// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "faults/campaign.hpp"
#include "result/document.hpp"

namespace fantail::faults {

/// The cells that came to it.
[[nodiscard]] std::size_t count(const Result& result, Colour colour);
/// Any cell red that no known limit excuses.
[[nodiscard]] bool has_red(const Result& result);
/// Any cell red for a known limit.
[[nodiscard]] bool has_red_limit(const Result& result);
/// Is every cell safe? Undecided where one is not, for a limit that is known.
[[nodiscard]] result::Answer answer_of(const Result& result);
[[nodiscard]] result::Answer answer_of(Colour colour);

/// Of a cell with a known limit: what a team has to do, and whether the rocket that was flown already does.
[[nodiscard]] std::string what_to_do(const CellResult& cell);
/// "safe", "RED", "a known limit", "not judged further".
[[nodiscard]] const char* word_of(Colour colour);
/// How many cells came to what, the worst first, with the flight that is farthest off.
[[nodiscard]] std::string headline(const Result& result);

/// What a person types to fly it, and one run of it alone.
[[nodiscard]] std::string command_of(const Campaign& campaign);
[[nodiscard]] std::string run_command(const Campaign& campaign, const Cell& cell, std::uint64_t number);

// Its picture and its tables.

/// A row for each fault, a column for each phase, a cell in the colour of what it came to.
[[nodiscard]] std::string map_svg(const Result& result, double width);

/// Of one device each fault against each phase.
[[nodiscard]] std::vector<result::Block> matrix(const Result& result, std::string_view device);
/// The cells that are red, or safe though a limit is listed.
[[nodiscard]] result::Table not_green(const Result& result);
/// Of their faults why, and what to do.
[[nodiscard]] result::Table reasons(const Result& result);
/// What is safe, of the devices that were asked for.
[[nodiscard]] result::Table stated(const Result& result);
/// The worst one of each of the worst faults.
[[nodiscard]] result::Links worst_flights(const Result& result);

/// All of it, for every output; and of one run alone, `report` being its flight report.
[[nodiscard]] result::Document answer(const Result& result, const result::Made& made = {});
[[nodiscard]] result::Document answer(const Campaign& campaign, const Alone& alone, const std::string& report,
                                      const result::Made& made = {});
[[nodiscard]] std::vector<result::Listed> listed_fields();

}  // namespace fantail::faults
