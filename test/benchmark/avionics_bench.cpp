// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "benchmark/recorded_flight.hpp"
#include "sim/simulated_board.hpp"

namespace fantail::benchmark {
namespace {

// Every tick of the recorded flight, from power-up to a second after apogee. The copy of the recorded hardware into the
// simulated one is timed with it, as some driver has to put samples there in every world.
void avionics_tick(::benchmark::State& state) {
  const RecordedFlight& flight = recorded_flight();
  for ([[maybe_unused]] auto _ : state) {
    sim::SimulatedBoard board{flight.scenario.plan};
    core::Phase phase = core::Phase::safe;
    for (const RecordedTick& recorded : flight.ticks) {
      board.hardware = recorded.hardware;
      if (recorded.inputs.arm_command) {
        board.avionics.command_arm();
      }
      const core::TickRecord* record = &board.avionics.tick();
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
