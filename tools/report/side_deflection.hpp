// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "flight/flight.hpp"

namespace fantail::report {

/// Of a canard from the angle of its shaft: from trim, and positive in the sense that rolls the rocket positively.
[[nodiscard]] double deflection_rad(const core::CanardPlan& canard, double angle_rad);

/// What four canards that do not stand alike do beside rolling the rocket: the sum of their deflections as vectors
/// across the axis, with the canards numbered around the rocket so that 1 lies opposite 3, and 2 opposite 4. An angle
/// of one canard; zero while all four turn alike. Deflections are those of the encoders, from the trims of the plan.
struct SideDeflection {
  double largest_rad = 0.0;
  double mean_rad = 0.0;
  /// The largest moment about the centre of gravity that this makes, in air of 1.225 kg/m3. Empty: the vehicle does not
  /// say where its canards are, or the speed is not known.
  std::optional<double> largest_moment_n_m{};

  friend bool operator==(const SideDeflection&, const SideDeflection&) = default;
};

/// Over the ticks in which all four encoders can be read. Empty without any, and without a plan.
[[nodiscard]] std::optional<SideDeflection> side_deflection(const flight::Flight& flight,
                                                            std::span<const flight::Row> control);

}  // namespace fantail::report
