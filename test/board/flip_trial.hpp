// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "board_flight.hpp"
#include "core/flight_plan.hpp"
#include "flip.hpp"
#include "pin_watch.hpp"

namespace fantail::board {

/// What came of a flip.
enum class Outcome : std::uint8_t {
  nothing,           ///< every pulse and phase as without it, and nothing is named
  unnamed,           ///< the phases as without it, other pulses, and nothing is named
  named,             ///< it flew on, and a fault was named
  crashed,           ///< the firmware noticed, reset itself, and the flight went on
  watchdog,          ///< the watchdog reset it, and the flight went on
  ended_for_fault,   ///< another phase than without it, and a fault was named
  ended_for_flight,  ///< the same, and none was
  safe,              ///< a reset, and then Safe
  stands,            ///< no ticks any more, and no reset
  no_end,            ///< the emulator or this program came to no end
};
inline constexpr std::size_t outcomes = 10;
[[nodiscard]] const char* name(Outcome outcome);

/// What a flight shows from a moment on, a tick at a time.
struct Course {
  static constexpr std::size_t most_ticks = 1300;
  static constexpr std::size_t most_pulses = 4 * 450;
  struct Heard {
    std::uint8_t line;
    float begin_s;
    float width_us;
  };

  std::size_t ticks = 0;
  std::array<std::uint8_t, most_ticks> phases{};
  std::array<float, most_ticks> roll_deg{};
  std::array<std::uint16_t, most_ticks> heard_by{};  ///< how many pulses by then
  std::array<Heard, most_pulses> pulses{};
};

/// What happened, to whom, and what was seen then.
struct Trial {
  int number = 0;
  std::size_t moment = 0;
  Region region{};
  std::uint32_t region_bytes = 0;
  Outcome outcome = Outcome::no_end;
  Pins pins{};
  float roll_error_deg = 0.0F;        ///< the farthest from the flight without it
  float silence_ms = 0.0F;            ///< the longest without a tick
  std::uint32_t pc = 0;               ///< where the processor was, within a block or two
  std::array<char, 24> place{};       ///< register or address, and bit
  std::array<char, 96> symbol{};      ///< of the address; of a register's flip, of the program counter
  std::array<char, 12> restart{};     ///< kind of the last reset that followed; empty: none
  std::array<char, 96> named{};       ///< by the bus, or the reason of the phase
  std::array<char, 160> complaint{};  ///< the last of the processor's
};

/// Flies a flight on, in a process of its own, as it is.
[[nodiscard]] std::optional<Course> fly_as_it_is(BoardFlight& flight);

/// Likewise, and the bit flips. `plain` is the flight without. Aloud: on stderr is what the console says from then on.
[[nodiscard]] Trial fly_with(BoardFlight& flight, const Image& image, const core::FlightPlan& plan,
                             const MemoryMap& map, const Course& plain, const Flip& flip, bool aloud);

}  // namespace fantail::board
