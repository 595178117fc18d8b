// SPDX-License-Identifier: MIT
#include "faults/shaft.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fantail::faults {
namespace {

constexpr double numeric_rad = 0.01 * sim::radians_per_degree;
constexpr double lags_to_rest = 7.0;  // a thousandth is left of a movement

/// By how much a servo of the batch's middle stands off an angle that the plan asks for.
double misunderstood_rad(const core::CanardPlan& canard, const sim::ServoParameters& servo, double asked_rad) {
  const double pulse_us =
      static_cast<double>(canard.pulse_centre_us) + static_cast<double>(canard.pulse_per_radian_us) * asked_rad;
  const double stands_rad =
      servo.centre_rad + (pulse_us - servo.pulse_centre_us) / servo.pulse_per_degree_us * sim::radians_per_degree;
  return std::abs(stands_rad - asked_rad);
}

}  // namespace

std::string_view meaning(Shaft shaft) {
  switch (shaft) {
    case Shaft::obeys: return "where its pulse commands it";
    case Shaft::late: return "where its pulse commands it, in five times the usual time";
    case Shaft::jolts: return "up to 4 deg from where its pulse commands it";
    case Shaft::stays_short: return "anywhere within its limit, at trim or not";
    case Shaft::runs_away: break;
  }
  return "anywhere up to its mechanical stop";
}

ShaftLimits shaft_limits(const sim::Scenario& scenario) {
  const sim::ServoParameters& servo = scenario.vehicle.servo;
  const sim::ServoSpread& spread = scenario.vehicle.servo_spread;
  const double longer = 1.0 + spread.share;
  const double limit_rad = static_cast<double>(scenario.plan.controller.canard_limit.radians());
  ShaftLimits limits{.travel_s = servo.frame_period_s + longer * (servo.delay_s + lags_to_rest * servo.lag_s) +
                                 2.0 * limit_rad / ((1.0 - spread.share) * servo.rate_limit_rad_s)};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const core::CanardPlan& canard = scenario.plan.canards.each[i];
    const double farthest_rad =
        std::max({misunderstood_rad(canard, servo, static_cast<double>(canard.trim.radians())),
                  misunderstood_rad(canard, servo, limit_rad), misunderstood_rad(canard, servo, -limit_rad)});
    limits.off_rad[i] = numeric_rad + 0.5 * longer * servo.backlash_rad + spread.centre_rad + farthest_rad;
  }
  for (const sim::Fault& fault : scenario.faults) {
    if (fault.device == sim::Device::servo) {
      limits.off_rad[fault.canard] = std::numeric_limits<double>::infinity();
    }
  }
  return limits;
}

}  // namespace fantail::faults
