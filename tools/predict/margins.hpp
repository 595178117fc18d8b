// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

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

/// Over the airframes of the runs, from one speed to another. Empty where a gain never reaches one.
[[nodiscard]] std::vector<MarginsAtSpeed> margins_over_speed(const sim::Scenario& scenario,
                                                             const std::vector<Run>& runs, double from_m_s,
                                                             double to_m_s);

}  // namespace fantail::predict
