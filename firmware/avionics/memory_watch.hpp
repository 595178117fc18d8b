// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/autopilot.hpp"
#include "core/flight_plan.hpp"

namespace fantail::avionics {

/// Is what lies in the memory still what was left there? A bit that flips by itself is one cause of damage, a program
/// that writes where it should not another.
///
/// The plan is held to the CRC-32C that it had when it came into force, a slice in each tick: all of it within 40 ms.
/// Of the flight law what moves a canard (limit, sense, trim, pulse) is compared with the plan, a canard a tick. In
/// flight the law as a whole, what it remembers included, has to be at the beginning of a tick what it was at the end
/// of the one before: by a sum that every single bit, and whatever else is wrong in one word, changes.
class MemoryWatch {
 public:
  /// A plan has come into force; `plan` is where it lies from now on. A law that was made of it is another one.
  [[gnu::cold]] void begin(const core::FlightPlan& plan);

  /// Ahead of the law's step.
  [[nodiscard]] bool intact(const core::Autopilot& law) const;

  /// In the time that is left when a tick's work is done.
  void look(const core::FlightPlan& plan, const core::Autopilot& law);

 private:
  std::uint32_t plan_crc_ = 0;
  std::uint32_t crc_so_far_ = 0;
  std::uint16_t looked_at_ = 0;  ///< bytes of the plan
  std::uint8_t canard_ = 0;
  bool damaged_ = false;
  std::optional<std::uint32_t> law_{};  ///< in flight: of what the last tick left
};

}  // namespace fantail::avionics
