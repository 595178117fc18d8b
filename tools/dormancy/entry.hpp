// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "dormancy/capture_forecast.hpp"
#include "dormancy/outlook.hpp"
#include "sim/scenario.hpp"

namespace fantail::dormancy {

/// So long the canards must have waited for core::Capture to know the offset that turns the rocket.
inline constexpr double offset_known_after_s = 0.5;

/// The rocket of a scenario as control begins, for the closed forms. Of a launch whose canards leave trim.
[[nodiscard]] RollAtEntry entry_of(const sim::Scenario& scenario, const Outlook& outlook);

/// What can be said of the capture beforehand, by the closed forms alone.
struct CaptureForecast {
  std::optional<double> residual_rate_rad_s{};  ///< the canards cannot stop the rotation: it comes to this
  std::optional<double> earliest_stop_s{};
  std::optional<double> path_m{};
  std::optional<double> longest_path_m{};
  std::string why_not{};                            ///< a clause, where no time is promised
  double path_left_m = 0.0;                         ///< until the air is too slow
  std::optional<double> within_s{};                 ///< from the angle of the flight
  std::optional<double> from_any_angle_within_s{};  ///< with its rate
};

/// Empty where nothing of it applies: the canards stay at trim, or the plan does not enter by capture. Times are
/// promised only for a rocket without faults, and only before the reference moves and the excitation begins.
[[nodiscard]] std::optional<CaptureForecast> capture_forecast(const sim::Scenario& scenario, const Outlook& outlook);

}  // namespace fantail::dormancy
