// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/sheet.hpp"

namespace fantail::bench {

// What the terminal table and the page both show: one row a figure, one column a canard.

struct Cell {
  std::string alone{};     ///< or what there is, when there is only one turn
  std::string together{};  ///< empty when there is only one
  bool alone_passed = true;
  bool together_passed = true;
};

struct SheetRow {
  std::string label{};
  std::string unit{};
  std::string allowed{};  ///< "at most 0.50", "5.50 to 6.50"; "per canard" when canards differ
  std::vector<Cell> cells{};
};

/// The heading: facts about rocket and avionics, a line each, for a terminal.
[[nodiscard]] std::string heading_lines(const Heading& heading);

/// In the order of Sheet::canards.
[[nodiscard]] std::vector<SheetRow> sheet_rows(const Sheet& sheet);

/// The finding on a canard. A step or a sine does not show enough for "healthy"; without a verdict there is none.
struct Finding {
  std::string_view name;  ///< for files: "reversed", "no_fault_seen"
  std::string_view text;  ///< for readers: "is reversed"
};
[[nodiscard]] Finding finding(const Sheet& sheet, const CanardResult& result, bool judged);

/// Why the avionics' own verdict may differ from the finding.
inline constexpr std::string_view about_monitor =
    "The avionics' own verdict is from the end of the exercise, with all canards commanded to their trims. It forgets "
    "past differences, so it shows less than this sheet.";

/// The rocket, for people.
[[nodiscard]] std::string title(const Heading& heading);

/// A name from a file, which must neither move the columns nor command the terminal.
[[nodiscard]] std::string printable(std::string text);

/// The plots of one canard: its turn alone, its turn with the others, and its steps in detail. HTML figures.
[[nodiscard]] std::string canard_charts(const CanardResult& result, const Sheet& sheet,
                                        const link::Recording& recording, const Exercise& exercise);

}  // namespace fantail::bench
