// SPDX-License-Identifier: MIT
#pragma once

#include "paper/claim.hpp"
#include "paper/print.hpp"
#include "paper/runs.hpp"

namespace fantail::paper {

// Each flies what it needs, works out the numbers that were printed, and draws the figures that were printed.

[[nodiscard]] Chapter air_chapter(const Tell& tell);            ///< Section 4.1.1
[[nodiscard]] Chapter swirl_chapter(const Tell& tell);          ///< Section 4.1.2
[[nodiscard]] Chapter first_launch_chapter(const Tell& tell);   ///< Section 4.2
[[nodiscard]] Chapter steps_chapter(const Tell& tell);          ///< Section 4.3.1, Table 2
[[nodiscard]] Chapter second_launch_chapter(const Tell& tell);  ///< Section 4.3.2
[[nodiscard]] Chapter print_chapter(const Print& print);
[[nodiscard]] Chapter inputs_chapter();  ///< what was taken as printed, and what no model here contains

}  // namespace fantail::paper
