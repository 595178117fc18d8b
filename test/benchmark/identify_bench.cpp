// SPDX-License-Identifier: MIT
#include "benchmark/identify_answer.hpp"
#include "identify/closed_loop/closed_loop.hpp"
#include "identify/model/brute_force.hpp"

namespace fantail::benchmark {
namespace {

using identify::model::Grid;
using identify::model::Start;

void grid(::benchmark::State& state) {
  const IdentifyTask& task = task_of(state);
  identify::model::GridResult found;
  for ([[maybe_unused]] auto _ : state) {
    found =
        identify::model::search_open_loop_grid(task.record, task.airframe, task.node_time_s, Start::measured, Grid{});
  }
  tell_grid(state, found);
}

void brute_force(::benchmark::State& state, bool whole_grid) {
  const IdentifyTask& task = task_of(state);
  identify::model::GridResult found;
  for ([[maybe_unused]] auto _ : state) {
    found = identify::model::search_by_brute_force(task.record, task.airframe, task.node_time_s,
                                                   whole_grid ? Grid{} : task.some_points);
  }
  tell_grid(state, found);
}

void continuous(::benchmark::State& state) {
  const IdentifyTask& task = task_of(state);
  identify::model::RollModel found;
  for ([[maybe_unused]] auto _ : state) {
    found = identify::model::fit_open_loop(task.record, task.airframe, task.node_time_s, Start::measured, Grid{});
  }
  tell(state, found);
}

// The sum of squares tells, beside the answer, that the continuous fit is not worse than the grid.
void tell_squares(::benchmark::State& state, const identify::model::RollModel& model) {
  const IdentifyTask& task = task_of(state);
  identify::closed_loop::Descent descent{task.record, task.airframe, task.loop, task.node_time_s, Start::measured};
  state.counters["squares_rad2"] = descent.squares_rad2(model);
}

void closed_loop_grid(::benchmark::State& state) {
  const IdentifyTask& task = task_of(state);
  identify::closed_loop::GridResult found;
  for ([[maybe_unused]] auto _ : state) {
    found = identify::closed_loop::search_grid(task.record, task.airframe, task.loop, task.node_time_s, Start::measured,
                                               Grid{});
  }
  tell(state, found.model);
  tell_squares(state, found.least_squares);
}

void closed_loop_continuous(::benchmark::State& state) {
  const IdentifyTask& task = task_of(state);
  identify::closed_loop::Fit found;
  for ([[maybe_unused]] auto _ : state) {
    found =
        identify::closed_loop::fit(task.record, task.airframe, task.loop, task.node_time_s, Start::measured, Grid{});
  }
  tell(state, found.model);
  tell_squares(state, found.model);
}

}  // namespace
}  // namespace fantail::benchmark

using namespace fantail::benchmark;

BENCHMARK(grid)->Name("identify_grid")->Arg(100)->Arg(1000);
BENCHMARK(continuous)->Name("identify_continuous")->Arg(100)->Arg(1000);
BENCHMARK_CAPTURE(brute_force, all, true)->Name("identify_brute_force")->Arg(100);
BENCHMARK_CAPTURE(brute_force, some, false)->Name("identify_brute_force")->Arg(1000);
BENCHMARK(closed_loop_grid)->Name("identify_closed_grid")->Arg(100)->Arg(1000);
BENCHMARK(closed_loop_continuous)->Name("identify_closed_continuous")->Arg(100)->Arg(1000);
