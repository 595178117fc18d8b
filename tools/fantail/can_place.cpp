// SPDX-License-Identifier: MIT
#include "fantail/can_place.hpp"

#include <algorithm>
#include <thread>

#include "fantail/progress.hpp"

namespace fantail::tool {
namespace {

constexpr hal::Microseconds gathering_time{2'000};

}  // namespace

void CanPlace::wait(hal::Microseconds at_most) {
  const hal::Microseconds end = now() + at_most;
  if (bus_.wait(at_most)) {
    // Frames come 2700 times a second; nobody needs to wake for each.
    std::this_thread::sleep_for(std::clamp(end - now(), hal::Microseconds{0}, gathering_time));
  }
  if (take_interrupt()) {
    throw Interrupted{"interrupted"};
  }
}

}  // namespace fantail::tool
