// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "campaign/flown_run.hpp"

namespace fantail::benchmark {
namespace {

// A run of a campaign as it stands in a row of runs.csv: the files read with what it drew, the flight from power-up to
// its end, figures and verdict. One thread.
void campaign_run(::benchmark::State& state) {
  constexpr std::uint64_t seed = 1;
  constexpr std::uint64_t runs = 1'000'000;
  input::ScenarioFiles files = input::ScenarioFiles::load("tasha3_launch2");
  const campaign::Drawer drawer{{}, seed};
  std::uint64_t run = 0;
  for ([[maybe_unused]] auto _ : state) {
    const campaign::FlownRun flown = campaign::fly_run(files, drawer, seed, run++ % runs);
    if (!flown.note.empty()) {
      state.SkipWithError(flown.note.c_str());
    }
  }
  using ::benchmark::Counter;
  state.counters["flights_per_s"] = Counter(1.0, Counter::kIsIterationInvariantRate);
}

}  // namespace
}  // namespace fantail::benchmark

BENCHMARK(fantail::benchmark::campaign_run)->Name("campaign_run");
