// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace fantail::tool {

/// What every verb of the bench is told.
struct BenchOptions {
  std::string interface;
  bool json = false;
};

/// --can and --json.
void add_bench_options(CLI::App& verb, BenchOptions& options, const std::string& json_meaning);

// Each verb of the bench in a file of its own.
void add_bench_watch(CLI::App& bench);
void add_bench_limits(CLI::App& bench);
void add_bench_step(CLI::App& bench);
void add_bench_sine(CLI::App& bench);
void add_bench_arm(CLI::App& bench);
void add_bench_plan(CLI::App& bench);
void add_bench_log(CLI::App& bench);

}  // namespace fantail::tool
