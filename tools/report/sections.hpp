// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flight/flight.hpp"
#include "page/live.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"
#include "result/document.hpp"

// The parts of a flight's document; one with nothing to show is left out.
namespace fantail::report {

[[nodiscard]] std::vector<std::string> beside_the_verdict(const flight::Flight& flight, const Figures& figures,
                                                          const Verdict& verdict);
/// With the loop's margins, and why it rests where it rests.
[[nodiscard]] result::Section figures_section(const flight::Flight& flight, const Figures& figures,
                                              const Verdict& verdict);
[[nodiscard]] result::Section events_section(const flight::Flight& flight, const Verdict& verdict);
[[nodiscard]] result::Section phases_section(const flight::Flight& flight);
[[nodiscard]] result::Section notes_section(const flight::Flight& flight);

// Of a page alone.

/// Where the rocket went, of a flight with a path.
[[nodiscard]] result::Section path_section(const flight::Flight& flight);
/// How it turned about all three axes, of a flight on the gimbal or on pins.
[[nodiscard]] result::Section turning_section(const flight::Flight& flight);
/// Empty for a flight without rows.
[[nodiscard]] page::LiveCharts charts(const flight::Flight& flight);
/// The rocket as it rolled, and beside it the same without control; `begin_s` is the begin of the charts. Empty where
/// no roll is known.
[[nodiscard]] std::optional<page::RollScene> roll_scene(const flight::Flight& flight, double begin_s);

/// Where a point lies, seen from the foot of the guide: "north-east".
[[nodiscard]] std::string compass(const flight::PathPoint& point);
/// The point of the path at apogee.
[[nodiscard]] std::optional<flight::PathPoint> apogee_of(const flight::Flight& flight);

/// Where a rocket first was on the ground again.
struct Landing {
  flight::PathPoint at;
  bool under_parachute = false;  ///< else it fell, which no model here covers
};
/// Empty for a flight that ends in the air or whose path has no direction.
[[nodiscard]] std::optional<Landing> landing_of(const flight::Flight& flight);

}  // namespace fantail::report
