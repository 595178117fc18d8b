// SPDX-License-Identifier: MIT
#include "link/plan_reader.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "link/log_reader.hpp"
#include "protocol/plan_block.hpp"
#include "replies/sentence.hpp"

namespace fantail::link {
namespace {

constexpr hal::Microseconds glance{2'000};
// Of the reports that are waited for, the slowest comes once a second.
constexpr hal::Microseconds report_time{3'000'000};
constexpr std::uint64_t heartbeats_of_one = 5;

template <typename Message>
Message next_report(Place& place, AvionicsLink& link, std::uint64_t after) {
  for (Timeout timeout{report_time, place.now()}; link.count<Message>() <= after; link.listen(place.now())) {
    if (timeout.expired(place.now())) {
      throw LinkError{"the avionics has stopped reporting"};
    }
    link.expect_one_rocket();
    place.wait(glance);
  }
  link.expect_one_rocket();
  return link.reported<Message>("plan in force");
}

core::FlightPlan plan_of(const std::vector<std::byte>& block) {
  const protocol::PlanBlockReading reading = protocol::read_plan_block(block);
  if (!reading.plan) {
    const protocol::PlanReply why{.state = protocol::TransferState::refused,
                                  .fault = protocol::TransferFault::bad_block,
                                  .block_fault = reading.fault};
    throw LinkError{"what the avionics sent is no plan that this program can read: " + replies::sentence(why)};
  }
  return *reading.plan;
}

}  // namespace

PlanInForce read_plan_in_force(Place& place, AvionicsLink& link) {
  const std::uint64_t before = link.count<protocol::HeartbeatReport>();
  const std::vector<std::byte> block = LogReader{place, link}.plan_block();
  const core::FlightPlan plan = plan_of(block);
  const std::uint32_t block_crc = protocol::plan_block_crc(block);
  link.listen(place.now());
  // One that came after the plan, and as many as it takes to hear a second rocket.
  const auto heartbeat = next_report<protocol::HeartbeatReport>(
      place, link, std::max(link.count<protocol::HeartbeatReport>(), before + heartbeats_of_one));
  if (heartbeat.plan_crc != block_crc) {
    throw LinkError{fmt::format(
        "the plan that was read has block_crc {:08x}, and the avionics reports {:08x}: was a plan sent meanwhile?",
        block_crc, heartbeat.plan_crc)};
  }
  const auto board = next_report<protocol::BoardReport>(place, link, 0);
  return {.plan = plan, .block_crc = block_crc, .source = board.plan};
}

}  // namespace fantail::link
