// SPDX-License-Identifier: MIT
// From any state of the mixer, with the canards of any validated plan, any time, any roll command, any request and any
// encoder readings, not-a-number and infinities included, in the first motion and after it: the command of each canard
// is within the plan limit, the hard limit and its mechanical stop, and so within the smallest of them. Because this
// holds from any state, it holds after any number of ticks, after a reset, and with a position of which a bit has
// flipped. CANARDS: how many of the four are looked at; all go through the same lines.
#include "core/canard_mixer.cpp"

#include "any_mixer.hpp"

using namespace fantail;
using namespace fantail::core;
using namespace fantail::proof;

int main() {
  const AnyCanards canards;
  CanardMixer mixer{canards.plan, canards.plan_limit};
  Anything anything;
  mixer.visit_state(anything);

  const bool was_done = mixer.canards_[0].first_motion_done;
  CanardCommands commands{};
  mixer.mix(any_instant(), any_angle(), any_request(), any_encoders(), commands);

  for (std::size_t i = 0; i < CANARDS; ++i) {
    CLAIM(abs(commands[i].angle) <= canards.plan_limit);
    CLAIM(abs(commands[i].angle) <= hard_canard_limit);
    CLAIM(abs(commands[i].angle) <= canards.plan.each[i].mechanical_stop);
  }

  REACHABLE(1, was_done && commands[0].limited);
  REACHABLE(2, !was_done && commands[0].driven && commands[0].limited);
  REACHABLE(3, !was_done && commands[0].driven && !commands[0].limited);
  return 0;
}
