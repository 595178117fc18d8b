// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

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

}  // namespace fantail::page
