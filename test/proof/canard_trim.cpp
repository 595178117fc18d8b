// SPDX-License-Identifier: MIT
// From any state of the mixer, with the canards of any validated plan: when the roll command is zero and nothing is
// requested, a canard whose first motion is done is commanded to its trim, exactly, and says that it is not limited; a
// canard that is in its first motion and says that it is not limited is at its trim. A request that is not a number
// means trim, too. A pulse is a number that differs from the plan's centre by no more than 800.1 us.
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

  const bool done = mixer.canards_[0].first_motion_done;
  std::optional<std::array<Angle, canard_count>> request;
  if (nondet_bool()) {
    request = std::array<Angle, canard_count>{any_angle(), any_angle(), any_angle(), any_angle()};
    assume(!is_finite((*request)[0].radians()));
  }
  CanardCommands commands{};
  mixer.mix(any_instant(), Angle{}, request, any_encoders(), commands);

  const CanardCommand& first = commands[0];
  const Angle trim = canards.plan.each[0].trim;
  CLAIM(!done || (first.driven && first.angle == trim));
  CLAIM(!done || request || !first.limited);
  CLAIM(done || request || !first.driven || first.limited || first.angle == trim);

  REACHABLE(1, done && !request);
  REACHABLE(2, done && request);
  REACHABLE(3, !done && first.driven && !first.limited);
  return 0;
}
