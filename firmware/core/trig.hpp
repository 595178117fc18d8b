// SPDX-License-Identifier: MIT
#pragma once

#include "core/angle.hpp"

namespace fantail::core {

// Polynomials of our own, because no two C libraries agree in the last bit: with these the same flight gives the same
// bytes on every target. Against double precision, as measured in trig_test.cpp: sine and cosine are within 2 units in
// the last place where the result is beyond 0.01, and within 1.1e-7 everywhere; atan2 is within 3.5 units. A zero comes
// out without its sign.

/// Valid for |angle| <= 10 000 rad; beyond that, or for NaN, the result is NaN (never a wrong number).
[[nodiscard]] float sin(Angle angle);
/// Valid where sin() is, and NaN elsewhere.
[[nodiscard]] float cos(Angle angle);

/// Sine of a phase in turns (1 turn = 2 pi): the way to take the sine of a long-running oscillation, because whole
/// turns drop out without rounding. Valid for |turns| <= 1e6; otherwise NaN.
[[nodiscard]] float sin_turns(float turns);

/// Angle of the point (x, y), in [-pi, pi]; zero for the origin, and a negative zero counts as zero. NaN for a NaN and
/// for two infinities.
[[nodiscard]] Angle atan2(float y, float x);

}  // namespace fantail::core
