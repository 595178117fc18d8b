// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "degree.hpp"
#include "input/document.hpp"
#include "input/scenario_file.hpp"
#include "sim/world.hpp"

namespace fantail::sim {

struct Tick {
  core::TickRecord record;
  Truth truth;
  double time_s;  ///< after lift-off, or control start in the tunnel; after power-up where neither happened
};

struct FlownWorld {
  std::vector<Tick> ticks;
  World::Events events;

  /// The first tick at or after a time.
  [[nodiscard]] const Tick& at(double time_s) const {
    for (const Tick& tick : ticks) {
      if (tick.time_s >= time_s - 1e-9) {
        return tick;
      }
    }
    throw std::out_of_range{"the run ended before " + std::to_string(time_s)};
  }

  /// The first tick in a phase; null when there is none.
  [[nodiscard]] const Tick* first_in(core::Phase phase) const {
    for (const Tick& tick : ticks) {
      if (tick.record.phase == phase) {
        return &tick;
      }
    }
    return nullptr;
  }
};

inline FlownWorld fly(const Scenario& scenario) {
  constexpr std::size_t longest_run = 2'000'000;
  World world{scenario};
  FlownWorld flown;
  while (!world.over()) {
    const core::TickRecord& record = world.tick();
    flown.ticks.push_back({record, world.truth(), 1e-6 * static_cast<double>(record.time.count())});
    world.advance();
    if (flown.ticks.size() > longest_run) {
      throw std::runtime_error{"this world does not end"};
    }
  }
  flown.events = world.events();
  if (flown.events.liftoff) {
    for (Tick& tick : flown.ticks) {
      tick.time_s = 1e-6 * static_cast<double>((tick.record.time - *flown.events.liftoff).count());
    }
  }
  return flown;
}

/// A shipped scenario with changes as on the command line.
inline Scenario scenario(const std::string& name, const std::vector<std::string>& changes = {}) {
  return input::load_scenario(name, input::parse_overrides(changes));
}

inline FlownWorld fly(const std::string& name, const std::vector<std::string>& changes = {}) {
  const Scenario loaded = scenario(name, changes);
  return fly(loaded);
}

}  // namespace fantail::sim
