// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "benchmark/recorded_flight.hpp"
#include "hal/sim/can_bus.hpp"
#include "hal/sim/console.hpp"
#include "hal/sim/entropy.hpp"
#include "hal/sim/flash.hpp"
#include "sim/pad_crew.hpp"
#include "sim/simulated_board.hpp"

namespace fantail::benchmark {
namespace {

// Every tick of the recorded flight, from power-up to a second after apogee. The copy of the recorded hardware into the
// simulated one is timed with it, as some driver has to put samples there in every world.
void avionics_tick(::benchmark::State& state) {
  const RecordedFlight& flight = recorded_flight();
  for ([[maybe_unused]] auto _ : state) {
    hal::sim::CanWire wire;
    hal::sim::CanBus can_bus{wire};
    hal::sim::Flash flash{{.size = 1U << 17U, .sector_size = 4096, .page_size = 256}};
    hal::sim::Console console;
    hal::sim::Entropy entropy;
    sim::PadCrew crew{wire, std::chrono::seconds{1}};
    sim::SimulatedBoard board{flight.scenario.plan,
                              {.can_bus = can_bus, .flash = flash, .console = console, .entropy = entropy}};
    core::Phase phase = core::Phase::safe;
    for (const RecordedTick& recorded : flight.ticks) {
      board.hardware() = recorded.hardware;
      crew.act(recorded.hardware.time);
      const core::TickRecord* record = &board.tick();
      ::benchmark::DoNotOptimize(record);
      phase = record->phase;
    }
    if (phase != flight.ticks.back().phase) {
      state.SkipWithError("the replay differs from the flight");
    }
  }
  const auto ticks = static_cast<double>(flight.ticks.size());
  state.counters["time_per_tick"] =
      ::benchmark::Counter(ticks, ::benchmark::Counter::kIsIterationInvariantRate | ::benchmark::Counter::kInvert);
}

}  // namespace
}  // namespace fantail::benchmark

BENCHMARK(fantail::benchmark::avionics_tick)->Name("avionics_tick");
