// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/flight_plan.hpp"
#include "sim/vehicle.hpp"
#include "stability/speed_range.hpp"

namespace fantail::airframe {

/// A straight ascent from where control begins to apogee.
struct ControlledAscent {
  stability::SpeedRange range{};  ///< down to 20 m/s, or to where control begins if that is slower
  double begin_m_s = 0.0;         ///< the speed at which control begins
  struct Moment {
    double speed_m_s;
    double height_m;
  };
  std::vector<Moment> coast{};  ///< after the top speed: slower and higher

  /// The density of the air where it is thinnest at this speed, over that at the launch site.
  [[nodiscard]] double thinner(double speed_m_s) const;
};

/// Empty: control never begins.
[[nodiscard]] std::optional<ControlledAscent> controlled_ascent(const sim::Vehicle& vehicle,
                                                                const core::FlightPlan& plan);

}  // namespace fantail::airframe
