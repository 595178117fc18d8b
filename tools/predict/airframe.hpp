// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

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

/// Airframes as the rocket on the pad may be one: Student's t distribution with one degree of freedom less than there
/// are steps, with the correlation of damping, torque and both offsets that the steps have among themselves. For each
/// of the four numbers that is the predictive distribution of one more step: a normal law would take the spread of a
/// few steps for the true one. The variance of measurement, as far as the tunnel states standard errors, is taken off:
/// it is no property of the airframe. It stays in the doubt that so few steps leave about their mean. What has a
/// damping or torque of zero or less is drawn again.
class AirframeSpread {
 public:
  /// Takes `fewest_tunnel_steps` or more, and a standard error for each number of each, or none at all.
  AirframeSpread(const std::vector<TunnelStep>& steps, const DampingFactor& damping,
                 const std::optional<AreaFactor>& area = {}, const std::vector<TunnelStep>& standard_errors = {});

  /// The same seed gives the same airframe.
  [[nodiscard]] TunnelStep draw(std::uint64_t seed) const;

 private:
  using Numbers = std::array<double, 4>;

  std::vector<Numbers>
      deviations_;  ///< of each step from their mean, so scaled that their squares add up to the variance
  Numbers mean_{};
  std::size_t degrees_of_freedom_;
  DampingFactor damping_;
  std::optional<AreaFactor> area_;
};

}  // namespace fantail::predict
