// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"

namespace fantail::core {

/// The roll angle to hold at a time after control start (>= 0): constant, stepped, or a square wave
/// (R0 - R1) H(sin(2 pi f0 t)) + R1 (Eq 12). The half wave is found from the integer time, because the sign of the
/// sine at a multiple of the half period depends on rounding; each half wave begins on its microsecond and none drifts.
[[nodiscard]] Angle roll_reference(const ReferencePlan& plan, Microseconds since_control_start);

}  // namespace fantail::core
