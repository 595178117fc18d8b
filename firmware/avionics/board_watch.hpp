// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "avionics/flash_facts.hpp"
#include "core/flight_phase.hpp"
#include "core/time.hpp"
#include "hal/board.hpp"
#include "hal/console.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::avionics {

/// What is wrong with the board, for whoever asks: those who let a rocket be armed, the bus, and a person at the
/// console.
class BoardWatch {
 public:
  /// However often faults come and go, they are reported no sooner than this after the last time.
  static constexpr core::Microseconds shortest_pause{100'000};

  /// Once a tick. `missed_ticks`: by the flight law's own count; the board's goes on where a new plan has set that one
  /// back.
  void look(const hal::BoardStatus& status, std::uint32_t missed_ticks, std::uint32_t overrun_limit);

  [[nodiscard]] hal::BoardFaults faults() const { return status_.faults; }
  /// With any fault the rocket is not armed.
  [[nodiscard]] bool faulty() const { return !status_.faults.none(); }
  [[nodiscard]] protocol::BoardReport report(const FlashFacts& flash) const;

  /// Once a tick, after look(): at power-up, and when something has changed, names all of it at the console. True when
  /// it did.
  bool tell(core::Microseconds now, core::Phase phase, const FlashFacts& flash, hal::Console& console);

 private:
  struct Told {
    hal::BoardFaults faults{};
    std::optional<protocol::PlanSource> plan{};
    bool flash_failed = false;
    friend bool operator==(const Told&, const Told&) = default;
  };

  hal::BoardStatus status_{};
  Told told_{};
  std::optional<core::Microseconds> told_at_{};  ///< empty: nothing yet
};

/// What lamp and buzzer show. `reason`: of the phase. `fit`: nothing that has been found so far keeps the rocket from
/// being armed.
[[nodiscard]] hal::Signal signal_of(core::Phase phase, core::PhaseReason reason, bool self_test_running, bool fit);

}  // namespace fantail::avionics
