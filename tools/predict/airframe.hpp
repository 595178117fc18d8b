// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/next_row.hpp"
#include "predict/tunnel_result.hpp"
#include "sim/scenario.hpp"

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

// What the steps of a tunnel say of the vehicle that is to fly.

/// Throws text::Error for steps of a vehicle with another name than the scenario's. A file that does not name the
/// vehicle is accepted.
void require_same_vehicle(const sim::Scenario& scenario, const TunnelResult& tunnel);

/// Damping and torque for the reference area of the vehicle, which they scale inversely with.
[[nodiscard]] TunnelResult for_vehicle(const sim::Scenario& scenario, TunnelResult tunnel);

/// The range of the vehicle's reference area, where the steps do not say which one they were identified with.
[[nodiscard]] std::optional<AreaFactor> area_factor(const sim::Scenario& scenario, const TunnelResult& tunnel);

// A sentence each.

[[nodiscard]] std::string whose_rows(const sim::Scenario& scenario, const TunnelResult& tunnel);
/// What is identified is the product of an area with damping and torque.
[[nodiscard]] std::string which_area(const sim::Scenario& scenario, const TunnelResult& tunnel);
/// What was identified with the fins on has their wash in it. Empty for a vehicle without wash.
[[nodiscard]] std::optional<std::string> wash_in_rows(const sim::Scenario& scenario, const TunnelResult& tunnel);

}  // namespace fantail::predict
