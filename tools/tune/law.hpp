// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/scenario.hpp"
#include "stability/gain_choice.hpp"
#include "stability/schedule.hpp"
#include "stability/speed_range.hpp"

namespace fantail::tune {

/// What a search chooses of a plan.
struct Law {
  stability::Gains gains{};
  double integral_gain_per_s = 0.0;       ///< with integral action
  double observer_bandwidth_rad_s = 0.0;  ///< with an observer
  double schedule_exponent = 0.0;         ///< factors (highest speed / speed)^exponent; zero: no schedule
};

/// A sentence on the schedules that no plan may have, and what would allow them; empty when all are within one.
[[nodiscard]] std::string schedules_left_out(const stability::SpeedRange& range);

/// The scenario's plan with this law, its gate kept. Behind a gate later than the guide it begins by capture. An
/// observer and capture get the vehicle's own roll model. Throws text::Error (bad_configuration) where such a law is no
/// plan: without a known speed there is neither schedule nor observer.
[[nodiscard]] core::FlightPlan with_law(const sim::Scenario& scenario, core::OffsetRejection rejection, const Law& law,
                                        const stability::SpeedRange& range);

}  // namespace fantail::tune
