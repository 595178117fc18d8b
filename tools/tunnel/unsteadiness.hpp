// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "tunnel/steady.hpp"
#include "tunnel/tunnel_log.hpp"

namespace fantail::tunnel {

/// How much the speed of the air varies at one set point of the fan, as shares of its mean.
struct Unsteadiness {
  double share = 0.0;           ///< standard deviation, that of the sensor's rounding taken off
  double rounding_share = 0.0;  ///< that of the rounding: a smaller one cannot be seen
};

/// Of the air between two instants: of all readings of the steady segment that lies around them, because two or three
/// readings say little; without one of those in between. Empty: fewer than five readings, or no wind.
[[nodiscard]] std::optional<Unsteadiness> unsteadiness(const TunnelLog& wind, const SteadySegments& steady,
                                                       double begin_s, double end_s);

}  // namespace fantail::tunnel
