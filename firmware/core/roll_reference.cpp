// SPDX-License-Identifier: MIT
#include "core/roll_reference.hpp"

namespace fantail::core {
namespace {

Angle step_reference(const ReferencePlan& plan, Microseconds t) {
  Angle reference = plan.initial;
  for (std::size_t i = 0; i < plan.step_times_count && t >= plan.step_times[i]; ++i) {
    reference = plan.step_angles[i];
  }
  return reference;
}

Angle square_wave_reference(const ReferencePlan& plan, Microseconds t) {
  if (t < plan.square_wave_begin) {
    return plan.initial;
  }
  // A plan lasts ten minutes at most, so 32 bits of microseconds suffice, and the Cortex-M4 divides them in hardware.
  const auto half_period = static_cast<std::uint32_t>(from_seconds(0.5F / plan.square_wave_frequency_hz).count());
  const auto elapsed = static_cast<std::uint32_t>((t - plan.square_wave_begin).count());
  return (elapsed / half_period) % 2U == 0U ? plan.square_wave_first : plan.square_wave_second;
}

}  // namespace

Angle roll_reference(const ReferencePlan& plan, Microseconds since_control_start) {
  switch (plan.kind) {
    case ReferenceKind::steps: return step_reference(plan, since_control_start);
    case ReferenceKind::square_wave: return square_wave_reference(plan, since_control_start);
    case ReferenceKind::hold: break;
  }
  return plan.initial;
}

}  // namespace fantail::core
