// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "hal/board.hpp"

namespace fantail::hal {

/// What lamp and buzzer do over and over, from the moment the signal is first shown: sixteen steps of an eighth of a
/// second, on where there is a #.
struct SignalPattern {
  std::string_view light;
  std::string_view sound;
};

inline constexpr std::uint32_t pattern_steps = 16;
inline constexpr std::uint32_t ticks_per_pattern_step = 125;

[[nodiscard]] constexpr SignalPattern pattern(Signal signal) {
  switch (signal) {
    case Signal::safe: return {"#...............", "................"};
    case Signal::faulty: return {"#.#.#.#.#.#.#.#.", "#.#............."};
    case Signal::self_test: return {"#.......#.......", "#...#...#...#..."};  // the canards move: hands off
    case Signal::armed: return {"##......##......", "##......##......"};
    case Signal::armed_not_ready: return {"#.#.....#.#.....", "#.#.....#.#....."};
    case Signal::flying: return {"################", "................"};
    case Signal::finished: return {"########........", "########........"};  // to be found by
  }
  return {"................", "................"};
}

}  // namespace fantail::hal
