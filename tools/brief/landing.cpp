// SPDX-License-Identifier: MIT
#include "brief/landing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fly/describe.hpp"
#include "hardover/study.hpp"

namespace fantail::brief {

std::string why_no_landing(const sim::Vehicle& vehicle) {
  if (!vehicle.airframe) {
    return "the vehicle has no section [airframe]";
  }
  if (!vehicle.canard_air.side_area_m2 && !fly::canard_side(vehicle)) {
    return "the side force of the canards is unknown (vehicle sections [shape] and [canard_fins])";
  }
  return {};
}

Landing landing(const Request& request, const std::function<void(std::size_t done, std::size_t of)>& look) {
  constexpr double hardly_away_m = 1.0;
  const hardover::Study study =
      hardover::fly(request.scenario, {.step_s = request.step_s, .threads = request.threads}, look);
  Landing landing{.has_parachute = study.has_parachute,
                  .healthy_fall_m = study.sound_fall_from_guide_m,
                  .flights = study.effects.size(),
                  .step_s = request.step_s};
  if (study.sound_landing_east_m && study.sound_landing_north_m) {
    landing.healthy_m = std::hypot(*study.sound_landing_east_m, *study.sound_landing_north_m);
    if (*landing.healthy_m >= hardly_away_m) {
      const double bearing_rad = std::atan2(*study.sound_landing_east_m, *study.sound_landing_north_m);
      landing.healthy_bearing_rad = bearing_rad < 0.0 ? bearing_rad + 2.0 * std::numbers::pi : bearing_rad;
    }
  }
  for (const hardover::Effect& effect : study.effects) {
    landing.failed_fall_m = std::max(landing.failed_fall_m, effect.fall_from_guide_m);
    landing.failed_m = std::max(landing.failed_m, effect.landing_from_guide_m);
    landing.failed_without_landing += effect.landing_from_guide_m ? 0 : 1;
  }
  return landing;
}

}  // namespace fantail::brief
