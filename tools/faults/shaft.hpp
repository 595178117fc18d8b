// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/flight_plan.hpp"
#include "sim/scenario.hpp"

namespace fantail::faults {

/// What the shaft of a canard whose servo fails may do until the fault is gone. No pulse of the avionics can help it:
/// this is the fault. Of all other canards, and of the others in its own row, every shaft has to obey.
enum class Shaft : std::uint8_t {
  obeys,        ///< stands where its pulse asks it to
  late,         ///< likewise, but later
  jolts,        ///< goes astray by no more than jolt_rad, for a moment
  stays_short,  ///< stands anywhere within its limit
  runs_away,    ///< stands anywhere up to its mechanical stop: nothing is asked of it
};
/// A clause: "anywhere up to its mechanical stop".
[[nodiscard]] std::string_view meaning(Shaft shaft);

using Shafts = std::array<Shaft, core::canard_count>;

inline constexpr double late_times = 5.0;  ///< how much longer a late shaft takes
inline constexpr double jolt_rad = 4.0 * sim::radians_per_degree;

/// How far a shaft that obeys may truly be from what its pulse asks for, and how long it takes to get there.
struct ShaftLimits {
  std::array<double, core::canard_count> off_rad{};
  double travel_s = 0.0;
};
/// By the play and the spread of the servos, and by the difference between the plan's pulses and theirs. Of a
/// canard that a fault of the scenario itself breaks nothing can be asked: infinite.
[[nodiscard]] ShaftLimits shaft_limits(const sim::Scenario& scenario);

}  // namespace fantail::faults
