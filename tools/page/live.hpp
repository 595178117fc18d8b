// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page/chart.hpp"

namespace fantail::page {

/// Where a rocket was, at the samples of a RollScene; from the foot of its guide.
struct ScenePath {
  struct Wind {
    double to_rad = 0.0;  ///< it blows there: 0 north, a quarter of a turn east
    std::string words{};  ///< "wind 5 m/s from the west"
  };
  std::vector<double> north_m{};
  std::vector<double> east_m{};
  std::vector<double> height_m{};
  std::optional<Wind> wind{};
};

/// A rocket that turns as one did, for the clock of the charts beside it. Samples are evenly spaced; angles in degrees,
/// not wrapped, and not a number where nobody knows them.
struct RollScene {
  std::string name{};  ///< of the rocket: "As flown"
  std::string note{};  ///< below it: whose angles these are
  double begin_s = 0.0;
  double step_s = 0.02;
  double shown_s = 0.0;  ///< where it stands at first
  double from_s = 0.0;   ///< where it begins to play
  std::vector<double> roll_deg{};
  std::vector<double> without_control_deg{};  ///< of a second rocket, whose canards are at trim; empty: there is none
  std::array<std::vector<double>, 4> canards_deg{};  ///< from trim; positive: so that it rolls the rocket positively
  std::optional<ScenePath> path{};
};

/// Charts over one clock, in seconds, that a reader can look into: where scripts run they share a cursor and are zoomed
/// together.
struct LiveCharts {
  struct View {
    std::string label{};
    double begin_s = 0.0;
    double end_s = 0.0;
  };
  /// The label is the title, the y label the unit. All series of a chart have the same x; those without a number are
  /// left out. Stripes and upright levels are those of the first chart. A y range is what is always in sight at least.
  std::vector<Chart> charts{};
  std::vector<Chart> more{};  ///< likewise, shown when a reader asks for them
  std::string more_label{};   ///< of the button
  std::optional<RollScene> scene{};
  std::vector<View> views{};  ///< stretches worth a button; the first is shown at first. Not empty if there are charts
};

/// The first chart as a picture that can stand by itself. It is what there is without scripts.
[[nodiscard]] std::string live_figure(const LiveCharts& live, std::string_view caption);

/// The charts as data, thinned without losing a peak, and the scripts that put them in the place of the figure: for the
/// end of the page, whose head must have uplot_css. Empty without charts.
[[nodiscard]] std::string live_scripts(const LiveCharts& live);

}  // namespace fantail::page
