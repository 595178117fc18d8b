// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "campaign/analysis.hpp"
#include "predict/run.hpp"
#include "sim/scenario.hpp"

namespace fantail::predict {

/// What the fins need and the canards give at one air speed of the climb, both as canard angles. Both torques grow with
/// the square of the speed, so that only two things change with it: the offset grows in the first 1.7 s, and the air
/// may overpower the servos.
struct AuthorityAtSpeed {
  double speed_m_s = 0.0;
  campaign::Quantiles needed_rad{};  ///< |fin offset| of the runs then
  double given_rad = 0.0;
};

struct SpeedAt {
  double after_liftoff_s = 0.0;
  double speed_m_s = 0.0;
};

/// Of one run, flown again: from lift-off to its top speed, in about a hundred steps of speed. Empty without lift-off.
[[nodiscard]] std::vector<SpeedAt> climb(const sim::Scenario& scenario, const Run& run);

/// `reach_rad`: canard_reach(). The stall torque of the servos over the hinge moment of a canard ends it earlier, where
/// the vehicle states both, in the air of the ground.
[[nodiscard]] std::vector<AuthorityAtSpeed> authority_over_speed(const sim::Scenario& scenario,
                                                                 const std::vector<Run>& runs,
                                                                 const std::vector<SpeedAt>& climb, double reach_rad);

}  // namespace fantail::predict
