// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "flight/flight.hpp"

namespace fantail::report {

/// Something pulled at the rocket after apogee, as an opening parachute does.
struct Jolt {
  double time_s = 0.0;               ///< of its begin, on the rows' clock
  double specific_force_m_s2 = 0.0;  ///< the largest along the axis within a second, not negative
};

/// The first stretch after apogee and burn-out (without one: after control that ended there) in which the accelerometer
/// reads more than 1.5 g along the axis, either way, for 20 ms. Air alone brings a falling rocket to 1 g at most.
/// Empty: none in the record, which may end before it.
[[nodiscard]] std::optional<Jolt> jolt_after_apogee(const flight::Flight& flight);

}  // namespace fantail::report
