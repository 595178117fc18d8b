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
  // Counted in millionths of a half wave: a whole number of microseconds for the half period would drift, and at 0.3 Hz
  // the third half wave would begin a tick late. Ten minutes at 10 Hz stay below 1.2e16.
  constexpr std::int64_t half_wave = 500'000'000'000;  // of a wave, in units of 1 us times 1 uHz
  const std::int64_t phase = (t - plan.square_wave_begin).count() * millionths(plan.square_wave_frequency_hz);
  return phase / half_wave % 2 == 0 ? plan.square_wave_first : plan.square_wave_second;
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
