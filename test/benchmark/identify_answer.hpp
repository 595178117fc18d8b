// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include "benchmark/identify_record.hpp"

namespace fantail::benchmark {

/// The task of a benchmark whose only argument is the sample rate.
[[nodiscard]] const IdentifyTask& task_of(const ::benchmark::State& state);

/// What was found stands beside its time, as counters, so that whoever reads the one can compare the other.
void tell(::benchmark::State& state, const identify::model::RollModel& model);

/// Likewise, with the number of points that the time is for, and the largest difference of an error from the expected
/// one.
void tell_grid(::benchmark::State& state, const identify::model::GridResult& found);

}  // namespace fantail::benchmark
