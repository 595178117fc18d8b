// SPDX-License-Identifier: MIT
#pragma once

#include "campaign/results.hpp"
#include "page/chart.hpp"

namespace fantail::campaign {

// The pictures of campaign.html.

/// The share over the number of runs, with the bounds that hold at every look.
[[nodiscard]] page::Chart convergence_chart(const Report& report);
/// How many of the runs are in each of equally wide bins, of a column whose values are not all the same.
[[nodiscard]] page::Chart histogram(const Column& column);
/// The figure of the question over one of the quantities: runs that meet it, runs that do not.
[[nodiscard]] page::Chart scatter(const Report& report, const std::string& quantity);

}  // namespace fantail::campaign
