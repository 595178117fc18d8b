// SPDX-License-Identifier: MIT
// For any validated excitation without seeded variation, in either form, at any time after control start up to an hour:
// the excitation is exactly zero outside of its window and where the plan has none, and never more than the plan's
// amplitude (but for a millionth of a radian). The sine is taken to be any number within 1.0000002, which is what
// test/core/trig_test.cpp finds.
#include "core/chirp.cpp"

#include "proof.hpp"

namespace fantail::core {

float sin_turns(float) {
  const float sine = nondet_float();
  proof::assume(sine >= -1.0000002F && sine <= 1.0000002F);
  return sine;
}

}  // namespace fantail::core

using namespace fantail;
using namespace fantail::core;
using namespace fantail::proof;

int main() {
  ExcitationPlan plan{};
  plan.form = any_of<ExcitationForm>(3);
  plan.amplitude = any_angle();
  plan.begin = any_instant();
  plan.end = any_instant();
  plan.product_slope_hz_s = nondet_float();
  plan.product_offset_hz = nondet_float();
  plan.sweep_first_hz = nondet_float();
  plan.sweep_last_hz = nondet_float();
  assume(plan.amplitude >= Angle{} && plan.amplitude <= Angle::from_degrees(20.01F));
  assume(plan.begin >= Microseconds{0} && plan.begin <= Microseconds{600'000'000});
  assume(plan.end > plan.begin && plan.end <= Microseconds{600'000'000});

  Chirp chirp{plan};
  const Microseconds t = any_instant();
  const Angle excitation = chirp.update(t);
  const bool on = plan.form != ExcitationForm::none && t >= plan.begin && t < plan.end;

  CLAIM(on || excitation == Angle{});
  CLAIM(abs(excitation) <= plan.amplitude + Angle::from_radians(1e-6F));

  REACHABLE(1, on && excitation > Angle::from_degrees(19.0F));
  return 0;
}
