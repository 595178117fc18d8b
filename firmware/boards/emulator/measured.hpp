// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::boards::emulator {

/// What an image knows about its own clock, in counts of it.
struct Measured {
  std::uint32_t instructions = 0;           ///< of a loop of known length, measured at start-up; 0: not measured
  std::uint32_t counts = 0;                 ///< that this loop took
  const volatile std::uint32_t* step = {};  ///< what the flight law took in this tick, where that is measured
};

}  // namespace fantail::boards::emulator
