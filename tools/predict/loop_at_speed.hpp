// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "predict/margins.hpp"
#include "predict/run.hpp"
#include "predict/share.hpp"
#include "sim/scenario.hpp"

namespace fantail::predict {

/// The loop's margins at one air speed, over the airframes of the runs.
struct MarginsAtSpeed {
  double speed_m_s = 0.0;
  Spread phase_margin_rad{};
  Spread crossover_rad_s{};
  std::optional<Spread> gain_margin{};  ///< empty when some airframe has none: no gain makes it swing
};

/// All dead time between a roll rate and the canard that answers it: the gyro's, the wait for the next pulse frame and
/// its hold, and the servo's own.
[[nodiscard]] double loop_delay_s(const sim::Vehicle& vehicle);

/// The loop of a scenario with this airframe, in the air at the launch site.
[[nodiscard]] RollLoop loop_at_speed(const sim::Scenario& scenario, const TunnelStep& airframe, double speed_m_s);

/// Over the airframes of the runs, from one speed to another. Empty where a gain never reaches one.
[[nodiscard]] std::vector<MarginsAtSpeed> margins_over_speed(const sim::Scenario& scenario,
                                                             const std::vector<Run>& runs, double from_m_s,
                                                             double to_m_s);

}  // namespace fantail::predict
