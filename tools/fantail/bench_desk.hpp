// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "bench/sheet.hpp"
#include "fantail/bench_options.hpp"
#include "link/avionics_link.hpp"
#include "link/place.hpp"
#include "link/session.hpp"
#include "sim/canard_tolerances.hpp"

namespace fantail::tool {

/// What is on the desk beside the rocket: the tolerances, and the plan that it should have.
struct Desk {
  sim::CanardTolerances tolerances{};
  bench::Heading heading{};
  std::optional<std::uint32_t> plan_crc;  ///< of the plan on this desk
};

/// --vehicle and --plan.
void add_desk_options(const Verb& verb, std::string& vehicle_name, std::string& plan_name);

/// Either name may be empty. Whatever is wrong with a file is said here, before anything moves.
[[nodiscard]] Desk desk(const std::string& vehicle_name, const std::string& plan_name);

/// Throws RequirementNotMet when the desk has a plan and the rocket holds another one.
void expect_plan_in_force(const Desk& desk, const BenchOptions& options, const link::AvionicsLink& link);

/// A folder that cannot be made is said now, and not after the work with the canards. `for_what`: "the sheet with
/// --out".
void expect_room(const std::filesystem::path& folder, const std::string& for_what);

[[nodiscard]] std::unique_ptr<link::Session> open_session(link::Place& place, link::AvionicsLink& link);

/// What the avionics has reported, into the heading of a sheet.
void complete(bench::Heading& heading, const BenchOptions& options, const link::AvionicsLink& link);

/// Centres the canards after an interrupt, and says what came of it.
[[nodiscard]] std::string centre_after_interrupt(link::Session& session);

}  // namespace fantail::tool
