// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "avionics/log_tick_of.hpp"
#include "avionics/record_queue.hpp"
#include "core/autopilot.hpp"
#include "core/flight_plan.hpp"
#include "protocol/log_tick.hpp"

namespace fantail::avionics {

/// The last half second on the pad (of two gyros 0.42 s, for which there is room), and what the flight law remembered
/// just before it. Checkpoints of the last half second would take five times the room of a second law that comes half a
/// second behind: each tick that leaves the queue is flown by it as a replay flies it.
class PadRing {
 public:
  static constexpr std::uint32_t ticks = 500;
  /// What the queue holds beside them, for a flash that has to catch up.
  static constexpr std::uint32_t room_beside = TickQueue::capacity_of_one_gyro - ticks;

  /// `law` and `times` are those before the next tick.
  void begin(const core::Autopilot& law, const protocol::SampleTimes& times, const SampleScales& scales,
             const core::CanardsPlan& canards);

  /// Makes room for one more tick.
  void retire_oldest(TickQueue& queue);

  // Before the oldest tick in the queue.
  [[nodiscard]] core::Autopilot& law() { return *law_; }
  [[nodiscard]] const protocol::SampleTimes& times() const { return times_; }

 private:
  std::optional<core::Autopilot> law_;
  protocol::SampleTimes times_{};
  SampleScales scales_{};
  core::CanardsPlan canards_{};
};

}  // namespace fantail::avionics
