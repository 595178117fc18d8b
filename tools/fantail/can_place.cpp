// SPDX-License-Identifier: MIT
#include "fantail/can_place.hpp"

#include "fantail/interrupt.hpp"

namespace fantail::tool {

void CanPlace::wait(hal::Microseconds at_most) {
  (void)bus_.wait(at_most);
  if (take_interrupt()) {
    throw Interrupted{"interrupted"};
  }
}

}  // namespace fantail::tool
