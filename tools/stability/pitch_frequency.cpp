// SPDX-License-Identifier: MIT
#include "stability/pitch_frequency.hpp"

#include <algorithm>
#include <cmath>

namespace fantail::stability {

std::optional<PitchFrequency> pitch_frequency(const sim::Airframe& airframe, double density_kg_m3) {
  const auto square_1_m2 = [&](const sim::Airframe::MassProperties& mass) {
    return 0.5 * density_kg_m3 * airframe.cross_section_m2() * airframe.normal_force_slope_per_rad *
           sim::static_margin_m(airframe, mass) / mass.transverse_inertia_kg_m2;
  };
  const auto [least, most] = std::minmax({square_1_m2(airframe.at_liftoff), square_1_m2(airframe.after_burnout)});
  return least > 0.0 ? std::optional{PitchFrequency{std::sqrt(least), std::sqrt(most)}} : std::nullopt;
}

}  // namespace fantail::stability
