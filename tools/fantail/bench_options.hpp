// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fantail/command_line.hpp"

namespace fantail::tool {

/// What every verb of the bench is told.
struct BenchOptions {
  std::string interface;
  bool json = false;
};

/// --can and --json.
void add_bench_options(const Verb& verb, BenchOptions& options, const std::string& json_meaning);

// Each verb of the bench in a file of its own.
void add_bench_watch(const Verb& bench);
void add_bench_limits(const Verb& bench);
void add_bench_step(const Verb& bench);
void add_bench_sine(const Verb& bench);
void add_bench_arm(const Verb& bench);
void add_bench_plan(const Verb& bench);
void add_bench_log(const Verb& bench);

}  // namespace fantail::tool
