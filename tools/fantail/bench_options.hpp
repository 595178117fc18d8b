// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "fantail/command_line.hpp"
#include "link/avionics_link.hpp"
#include "link/place.hpp"

namespace fantail::tool {

/// What every verb of the bench is told.
struct BenchOptions {
  std::string interface;
  bool json = false;
  std::optional<double> wait_s;
};

/// Until the avionics has been heard. With --wait also until the rocket is at rest, or that time is over: then the
/// avionics itself says what it refuses. Throws link::LinkError.
void await_rocket(const BenchOptions& options, link::Place& place, link::AvionicsLink& link);

/// --can, --wait and --json.
void add_bench_options(const Verb& verb, BenchOptions& options, const std::string& json_meaning);

/// `bench plan show`: the plan in force, read back, as a plan file.
void show_plan_in_force(const BenchOptions& options);

// Each verb of the bench in a file of its own.
void add_bench_watch(const Verb& bench);
void add_bench_limits(const Verb& bench);
void add_bench_step(const Verb& bench);
void add_bench_sine(const Verb& bench);
void add_bench_cycle(const Verb& bench);
void add_bench_hold(const Verb& bench);
void add_bench_axes(const Verb& bench);
void add_bench_arm(const Verb& bench);
void add_bench_plan(const Verb& bench);
void add_bench_log(const Verb& bench);
void add_bench_zero(const Verb& bench);

}  // namespace fantail::tool
