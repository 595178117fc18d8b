// SPDX-License-Identifier: MIT
#include "fantail/bench_desk.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <random>

#include <fmt/core.h>
#include <unistd.h>

#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "link/plan_transfer.hpp"
#include "protocol/plan_block.hpp"
#include "text/local_time.hpp"
#include "text/output_folder.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {

void add_desk_options(const Verb& verb, std::string& vehicle_name, std::string& plan_name) {
  verb.option("--vehicle", vehicle_name,
              "Vehicle whose tolerances are used: a shipped name or a path [default tolerances]")
      .offers(shipped(input::Shipped::vehicle))
      .value_name("FILE");
  verb.option("--plan", plan_name, "The plan that must be in force: a shipped name or a path")
      .offers(shipped(input::Shipped::plan))
      .value_name("PLAN");
}

Desk desk(const std::string& vehicle_name, const std::string& plan_name) {
  Desk desk;
  desk.heading.version = FANTAIL_VERSION;
  desk.heading.date = text::local_minute(std::chrono::system_clock::now());
  if (vehicle_name.empty()) {
    desk.heading.notes.emplace_back("No vehicle was named: the default tolerances are used.");
  } else {
    const sim::Vehicle vehicle =
        input::read_vehicle(input::Document::load(input::find_input(input::Shipped::vehicle, vehicle_name)));
    desk.heading.vehicle = vehicle.name;
    desk.tolerances = vehicle.canard_tolerances;
  }
  if (!plan_name.empty()) {
    const core::FlightPlan plan =
        input::read_plan(input::Document::load(input::find_input(input::Shipped::plan, plan_name)));
    desk.heading.plan = plan_name;
    desk.plan_crc = protocol::plan_crc(plan);
    desk.heading.planned_limit_rad.emplace();
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      const core::Angle limit = std::min(plan.controller.canard_limit, plan.canards.each[i].mechanical_stop);
      (*desk.heading.planned_limit_rad)[i] = static_cast<double>(limit.radians());
    }
  }
  return desk;
}

void expect_plan_in_force(const Desk& desk, const BenchOptions& options, const link::AvionicsLink& link) {
  const std::string& plan = desk.heading.plan;
  if (desk.plan_crc && *desk.plan_crc != link.reported<protocol::HeartbeatReport>("heartbeat").plan_crc) {
    throw RequirementNotMet{"the plan in the rocket is not " + plan + "; send it with fantail bench plan " +
                            text::shell_word(plan) + " --can " + text::shell_word(options.interface)};
  }
}

void complete(bench::Heading& heading, const BenchOptions& options, const link::AvionicsLink& link) {
  const auto& heartbeat = link.reported<protocol::HeartbeatReport>("heartbeat");
  heading.plan_crc = fmt::format("{:08x}", heartbeat.plan_crc);
  heading.avionics = fmt::format("{}, bus protocol {}", options.interface, heartbeat.version);
  heading.board = link.board();
  if (const auto& health = link.newest<protocol::HealthReport>()) {
    for (std::size_t i = 0; i < heading.monitor.size(); ++i) {
      heading.monitor[i] = health->message.verdicts[i];
    }
  }
}

std::vector<std::byte> block_of(const core::FlightPlan& plan) {
  std::array<std::byte, protocol::largest_plan_block> block{};
  const std::size_t size = protocol::write_plan_block(plan, block);
  return {block.begin(), block.begin() + static_cast<std::ptrdiff_t>(size)};
}

protocol::PlanReply send_block(link::Place& place, link::AvionicsLink& link, std::span<const std::byte> block,
                               const std::string& name) {
  Progress progress{"sending " + name,
                    {.unit = "bytes", .rate = " a second", .total = static_cast<double>(block.size())}};
  return link::send_plan(place, link, block, [&](std::size_t done) { progress.show(static_cast<double>(done)); });
}

void expect_room(const std::filesystem::path& folder, const std::string& for_what) {
  std::error_code ignored;
  std::filesystem::path there = std::filesystem::absolute(folder, ignored);
  while (!std::filesystem::exists(there, ignored) && there.has_relative_path()) {
    there = there.parent_path();
  }
  if (!std::filesystem::is_directory(there, ignored)) {
    throw text::OutputError{there.string() + ": not a folder; choose another one for " + for_what};
  }
  if (::access(there.c_str(), W_OK | X_OK) != 0) {
    throw text::OutputError{there.string() + ": " + std::strerror(errno) + "; choose another folder for " + for_what};
  }
}

std::unique_ptr<link::Session> open_session(link::Place& place, link::AvionicsLink& link) {
  try {
    return std::make_unique<link::Session>(place, link, static_cast<std::uint16_t>(std::random_device{}()));
  } catch (const Interrupted&) {
    throw Interrupted{"interrupted before any canard was asked to move"};
  }
}

std::string centre_after_interrupt(link::Session& session) {
  return session.close()
             ? "interrupted; the canards are centred"
             : "interrupted; the avionics did not answer, but it centres the canards by itself 0.1 s after the "
               "last heartbeat";
}

}  // namespace fantail::tool
