// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "benchmark/recorded_flight.hpp"

namespace fantail::benchmark {
namespace {

// All steps of one window of the recorded flight, again and again, from a copy of the autopilot that flew up to it: the
// copy is the only thing timed besides the steps, and there are thousands of them to it.
void step(::benchmark::State& state, Window window) {
  const RecordedFlight& flight = recorded_flight();
  core::Autopilot ready{flight.scenario.plan};
  for (std::size_t i = 0; i < window.begin; ++i) {
    ready.step(flight.ticks[i].inputs);
  }
  std::vector<core::Inputs> inputs;
  for (std::size_t i = window.begin; i < window.end; ++i) {
    inputs.push_back(flight.ticks[i].inputs);
  }
  const RecordedTick& last = flight.ticks[window.end - 1];
  for ([[maybe_unused]] auto _ : state) {
    core::Autopilot autopilot = ready;
    const core::TickRecord* record = nullptr;
    for (const core::Inputs& input : inputs) {
      record = &autopilot.step(input);
      ::benchmark::DoNotOptimize(record);
    }
    // The time of something else than the recorded flight would mean nothing.
    if (record->phase != last.phase || record->command != last.command) {
      state.SkipWithError("the replay differs from the flight");
    }
  }
  const auto steps = static_cast<double>(inputs.size());
  state.counters["time_per_step"] =
      ::benchmark::Counter(steps, ::benchmark::Counter::kIsIterationInvariantRate | ::benchmark::Counter::kInvert);
}

void autopilot_step_controlling(::benchmark::State& state) { step(state, recorded_flight().controlling_with_chirp()); }
void autopilot_step_armed(::benchmark::State& state) { step(state, recorded_flight().armed()); }

}  // namespace
}  // namespace fantail::benchmark

BENCHMARK(fantail::benchmark::autopilot_step_controlling)->Name("autopilot_step_controlling");
BENCHMARK(fantail::benchmark::autopilot_step_armed)->Name("autopilot_step_armed");
