// SPDX-License-Identifier: MIT
// From any state of the mixer, with the canards of any validated plan and any inputs: the pulse of canard 1, if that is
// driven, is a number within 800.2 us of the plan's centre, so between 99 and 2901 us; and if it is not driven, angle
// and pulse are zero. Canard 1 stands for the four (canard_trim.cpp). That a pulse is between 500 and 2500 us, which a
// plan must make sure of at both ends of its limit, is not proved.
#include "any_mixer.hpp"
#include "core/canard_mixer.cpp"

using namespace fantail;
using namespace fantail::core;
using namespace fantail::proof;

int main() {
  const AnyCanards canards;
  CanardMixer mixer{canards.plan, canards.plan_limit};
  Anything anything;
  mixer.visit_state(anything);
  CanardCommands commands{};
  mixer.mix(any_instant(), any_angle(), any_request(), any_encoders(), commands);

  const CanardCommand& first = commands[0];
  const float centre = canards.plan.each[0].pulse_centre_us;
  CLAIM(!first.driven || (first.pulse_us >= centre - 800.2F && first.pulse_us <= centre + 800.2F));
  CLAIM(first.driven || (first.pulse_us == 0.0F && first.angle == Angle{}));

  REACHABLE(1, first.driven);
  REACHABLE(2, !first.driven);
  return 0;
}
