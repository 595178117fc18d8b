// SPDX-License-Identifier: MIT
// From any state of the mixer, with the canards of any validated plan: when the roll command is zero and nothing is
// requested, canard 1, when its first motion is done, is commanded to its trim, exactly, and says that it is not
// limited; when it is in its first motion and says that it is not limited, it is at its trim. A request that is not a
// number means trim, too. Canard 1 stands for the four: CanardMixer::drive() is given one canard's own plan, state,
// encoder and wish, and nothing of the others.
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
