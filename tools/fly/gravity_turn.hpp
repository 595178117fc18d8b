// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "sim/scenario.hpp"
#include "sim/units.hpp"

namespace fantail::fly {

/// A guide that leans less costs a straight line less than two in a hundred of its height.
inline constexpr double slight_tilt_rad = 3.0 * sim::radians_per_degree;

inline constexpr double gravity_turn_step_s = 1e-3;

/// What a point mass does that points along its path as soon as it has left the guide.
struct GravityTurn {
  double apogee_m = 0.0;
  double apogee_s = 0.0;  ///< after lift-off
  std::optional<double>
      tilt_limit_s{};  ///< after lift-off, before apogee: the path tilts by more than the plan's tilt limit
  std::vector<double> tilts_rad{};  ///< of the path, counted from where the plan counts them (run.tilt_from), from
                                    ///< lift-off to apogee, every gravity_turn_step_s
};

/// A launch without wind and without lift: m dv/dt = (thrust - drag) along the path + m g down. On the guide the path
/// is that of the guide.
[[nodiscard]] GravityTurn gravity_turn(const sim::Scenario& scenario);

}  // namespace fantail::fly
