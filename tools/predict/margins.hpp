// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/analysis.hpp"
#include "predict/run.hpp"
#include "sim/scenario.hpp"
#include "stability/gain_choice.hpp"

namespace fantail::predict {

/// The loop's margins at one air speed, over the airframes of the runs. A loop whose gain never reaches one cannot
/// swing: it counts as a phase margin of half a turn.
struct MarginsAtSpeed {
  double speed_m_s = 0.0;
  campaign::Quantiles phase_margin_rad{};
  std::optional<campaign::Quantiles> crossover_rad_s{};  ///< empty, as the next, when some airframe has none
  std::optional<campaign::Quantiles> gain_margin{};      ///< no gain makes such an airframe swing
};

/// Whether some of its gain margins are factors below one: then a loop that holds swings with less gain, not with more.
[[nodiscard]] inline bool may_swing_with_less(const MarginsAtSpeed& at) {
  return at.gain_margin && at.gain_margin->p5 < 1.0;
}

/// The loops of the airframes of the runs at each of these speeds.
[[nodiscard]] stability::LoopsAtSpeeds loops_at_speeds(const sim::Scenario& scenario, const std::vector<Run>& runs,
                                                       const std::vector<double>& speeds_m_s);

/// 32 steps between the lowest and the highest speed under control of all runs; empty: none came under control.
[[nodiscard]] std::vector<double> speeds_flown(const core::FlightPlan& plan, const std::vector<Run>& runs);

/// Without the speeds at which no airframe can swing.
[[nodiscard]] std::vector<MarginsAtSpeed> margins_over_speed(const sim::Scenario& scenario,
                                                             const std::vector<Run>& runs,
                                                             const std::vector<double>& speeds_m_s);

/// Angles that differ by less are the same: more than a float, as a plan has them, differs from the number.
inline constexpr double same_angle_rad = 1e-6;

/// The fin offset of one sense that all canards together can balance, and what ends it.
struct CanardReach {
  double angle_rad = 0.0;
  std::string set_by{};  ///< "servo stop", "mechanical stop of canard 2 in the plan", ...; empty: the plan's own limit

  /// "9 degree canard limit", "4.5 degrees that the canards reach (servo stop)".
  [[nodiscard]] std::string text() const;
};

/// Against an offset with this sign, with sim::deflection_range().
[[nodiscard]] CanardReach canard_reach(const sim::Scenario& scenario, double offset_rad);

/// The same if the plan limit were as large as a plan may have it.
[[nodiscard]] CanardReach farthest_reach(const sim::Scenario& scenario, double offset_rad);

}  // namespace fantail::predict
