// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "flight/flight.hpp"
#include "page/live.hpp"
#include "page/page.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"

namespace fantail::report {

/// The path from the side and from above, tilt and angle of attack over time; empty for a flight without a path.
[[nodiscard]] std::string path_section(const flight::Flight& flight);

/// Rates about all three axes and tilt over time, true and measured; empty for a flight of which they are not known.
[[nodiscard]] std::string turning_section(const flight::Flight& flight);

/// Where a point lies, seen from the foot of the guide: "north-east".
[[nodiscard]] std::string compass(const flight::PathPoint& point);

/// What the report shows of a flight over time: phases as stripes, events as upright levels, and in degrees, metres and
/// seconds what was known on board and what was true. The first is the roll angle. Empty without a row.
[[nodiscard]] page::LiveCharts charts(const flight::Flight& flight);

/// Whether a verdict is good news; the colour of the page, the card and the terminal.
[[nodiscard]] page::Tone tone(const Verdict& verdict);

/// The rocket as it rolled from `begin_s` on, and as it would have rolled without control where that is known. Truth
/// where there is any, else the estimate. Empty where no roll angle is known.
[[nodiscard]] std::optional<page::RollScene> roll_scene(const flight::Flight& flight, double begin_s);

/// report.html: one page that loads nothing. Verdict, figures, tables and a picture of the roll angle are plain HTML;
/// where scripts run, plots with a common cursor take the picture's place.
[[nodiscard]] std::string html(const flight::Flight& flight, const Figures& figures, const Verdict& verdict);

}  // namespace fantail::report
