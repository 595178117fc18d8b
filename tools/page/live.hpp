// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page/chart.hpp"
#include "page/roll_scene.hpp"

namespace fantail::page {

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
