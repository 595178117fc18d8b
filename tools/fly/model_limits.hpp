// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flight/flight.hpp"
#include "sim/scenario.hpp"

namespace fantail::fly {

/// Where a simulated flight goes beyond what the model holds for: a guide that leans (the simulated rocket keeps to the
/// line of its guide), speeds near that of sound (for constant coefficients, or for the Prandtl-Glauert factor), a
/// thrust beyond the range of the accelerometers, and wind at the end of the guide. In the tunnel, too: fins that
/// reverse the roll, and servos too weak for the plan's limit.
class ModelLimits {
 public:
  /// The scenario outlives this object.
  explicit ModelLimits(const sim::Scenario& scenario) : scenario_{scenario} {}

  /// Each row, in order, and the flight as it is known by then.
  void add(const flight::Row& row, const flight::Flight& so_far);

  /// Of a flight, not in the tunnel, whose rows have been added; its Mach number is that of the air along the axis.
  [[nodiscard]] flight::Extremes extremes(const flight::Flight& flight) const;

  /// Of a flight whose rows have been added, a sentence each.
  [[nodiscard]] std::vector<std::string> gone_beyond(const flight::Flight& flight) const;

 private:
  const sim::Scenario& scenario_;
  double largest_dynamic_pressure_pa_ = 0.0;  ///< under control
  double top_mach_ = 0.0;
  double speed_at_top_mach_m_s_ = 0.0;
  double largest_specific_force_m_s2_ = 0.0;
  std::optional<double> exit_speed_m_s_{};   ///< at the end of the guide
  std::optional<double> start_speed_m_s_{};  ///< of control
};

}  // namespace fantail::fly
