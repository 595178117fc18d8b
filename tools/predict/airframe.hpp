// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "campaign/next_row.hpp"
#include "predict/tunnel_result.hpp"

namespace fantail::predict {

/// Factors on the damping, all as likely. The tunnel tends to show less damping than the flight has.
struct DampingFactor {
  double low = 1.0;  ///< above zero
  double high = 1.0;
};

/// Factors on damping and torque alike, because the area they are multiplied with is not known better: in 95 % of the
/// cases it lies between these two, with a log-normal law.
struct AreaFactor {
  double low = 1.0;  ///< above zero
  double high = 1.0;
};

/// Airframes as the rocket on the pad may be one: the next row of a table of tunnel steps (campaign::NextRow), with
/// both factors. What has a damping or torque of zero or less is drawn again.
class AirframeSpread {
 public:
  /// Takes `fewest_tunnel_steps` or more, and a standard error for each number of each, or none at all.
  AirframeSpread(const std::vector<TunnelStep>& steps, const DampingFactor& damping,
                 const std::optional<AreaFactor>& area = {}, const std::vector<TunnelStep>& standard_errors = {});

  /// The same seed gives the same airframe.
  [[nodiscard]] TunnelStep draw(std::uint64_t seed) const;

 private:
  campaign::NextRow next_step_;
  DampingFactor damping_;
  std::optional<AreaFactor> area_;
};

}  // namespace fantail::predict
