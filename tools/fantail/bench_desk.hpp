// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/sheet.hpp"
#include "fantail/command_line.hpp"
#include "link/avionics_link.hpp"
#include "link/place.hpp"
#include "link/session.hpp"
#include "sim/canard_tolerances.hpp"

namespace fantail::tool {

/// Options of every verb of the bench.
struct BenchOptions {
  std::string interface;
  bool json = false;
  std::optional<double> wait_s;
};

/// Waits until the avionics reports. With --wait also until the rocket is at rest or the time is over; in that case the
/// avionics itself refuses. Throws link::LinkError.
void await_rocket(const BenchOptions& options, link::Place& place, link::AvionicsLink& link);

/// --can, --wait and --json.
void add_bench_options(const Verb& verb, BenchOptions& options, const std::string& json_meaning);

/// `bench plan show`: the plan in force, read back, as a plan file.
void show_plan_in_force(const BenchOptions& options);

[[nodiscard]] std::vector<std::byte> block_of(const core::FlightPlan& plan);

/// As link::send_plan, with its progress on the terminal. `name`: of the plan.
[[nodiscard]] protocol::PlanReply send_block(link::Place& place, link::AvionicsLink& link,
                                             std::span<const std::byte> block, const std::string& name);

// Each verb of the bench in a file of its own.
void add_bench_watch(const Verb& bench);
void add_bench_limits(const Verb& bench);
void add_bench_step(const Verb& bench);
void add_bench_sine(const Verb& bench);
void add_bench_cycle(const Verb& bench);
void add_bench_hold(const Verb& bench);
void add_bench_axes(const Verb& bench);
void add_bench_arm(const Verb& bench);
void add_bench_dormancy(const Verb& bench);
void add_bench_plan(const Verb& bench);
void add_bench_log(const Verb& bench);
void add_bench_zero(const Verb& bench);

/// The given files: the tolerances, and the plan that the rocket should have.
struct Desk {
  sim::CanardTolerances tolerances{};
  bench::Heading heading{};
  std::optional<std::uint32_t> plan_crc;  ///< of the plan on this desk
};

/// --vehicle and --plan.
void add_desk_options(const Verb& verb, std::string& vehicle_name, std::string& plan_name);

/// Either name may be empty. Errors in a file are reported here, before anything moves.
[[nodiscard]] Desk desk(const std::string& vehicle_name, const std::string& plan_name);

/// Throws RequirementNotMet if a plan is given and the rocket has another one.
void expect_plan_in_force(const Desk& desk, const BenchOptions& options, const link::AvionicsLink& link);

/// Reports a folder that cannot be made now, and not after the work with the canards. `for_what`: "the sheet with
/// --out".
void expect_room(const std::filesystem::path& folder, const std::string& for_what);

[[nodiscard]] std::unique_ptr<link::Session> open_session(link::Place& place, link::AvionicsLink& link);

/// Puts the avionics' reports into the heading of a sheet.
void complete(bench::Heading& heading, const BenchOptions& options, const link::AvionicsLink& link);

/// Centres the canards after an interrupt, and returns a sentence on the result.
[[nodiscard]] std::string centre_after_interrupt(link::Session& session);

}  // namespace fantail::tool
