// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fantail/pad_script.hpp"
#include "fly/pace.hpp"
#include "sim/scenario.hpp"
#include "sim/world.hpp"

namespace fantail::tool {

/// A simulated rocket in real time on a real bus, with somebody at its pad who types.
class WorldInRealTime {
 public:
  using Clock = std::chrono::steady_clock;

  /// All outlive it. Beside `more` there are the commands for switch, abort input and igniter.
  WorldInRealTime(const sim::Scenario& scenario, const sim::BoardPorts& ports, const PadEar& ear,
                  const sim::MakeFlightComputer& make = sim::simulated_board, const std::vector<PadCommand>& more = {});

  /// Called after every tick, with its record and the time that it took.
  using Observe = std::function<void(const core::TickRecord& record, Clock::duration took)>;
  /// Until "quit", Ctrl-C or the end of that time.
  void run(const std::optional<double>& seconds, const Observe& observe);

  [[nodiscard]] const sim::World& world() const { return world_; }
  [[nodiscard]] fly::Pace& pace() { return pace_; }
  /// A sentence for the end: how long it ran, what was late, what went over the bus.
  [[nodiscard]] std::string summary(const hal::CanCounters& frames) const;

 private:
  [[nodiscard]] std::vector<PadCommand> commands(const std::vector<PadCommand>& more);

  sim::World world_;
  PadScript script_;
  fly::Pace pace_{Clock::now()};
  std::int64_t ticks_ = 0;
};

}  // namespace fantail::tool
