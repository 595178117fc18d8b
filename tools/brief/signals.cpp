// SPDX-License-Identifier: MIT
#include "brief/sentences.hpp"

namespace fantail::brief {

const std::array<SignalMeaning, 7>& signal_meanings() {
  using enum hal::Signal;
  static constexpr std::array all{
      SignalMeaning{safe, "Safe", "Not armed. Canards can move in a bench session."},
      SignalMeaning{faulty, "Safe, with a fault", "Cannot be armed."},
      SignalMeaning{self_test, "Self-test", "The canards move: hands off."},
      SignalMeaning{armed, "Armed and ready", "Waits for a launch. Later faults do not show."},
      SignalMeaning{armed_not_ready, "Armed, not ready", "Was moved; must rest before it can detect a launch."},
      SignalMeaning{flying, "Launched", "Canards may move. The arm switch is ignored."},
      SignalMeaning{finished, "Finished", "Canards commanded to trim until power is off and on."}};
  return all;
}

}  // namespace fantail::brief
