// SPDX-License-Identifier: MIT
#include "link/plan_reader.hpp"

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

template <typename Message>
Message next_report(Place& place, AvionicsLink& link, std::uint64_t after) {
  for (Timeout timeout{report_time, place.now()}; link.count<Message>() <= after; link.listen(place.now())) {
    if (timeout.expired(place.now())) {
      throw LinkError{"the avionics has stopped reporting"};
    }
    place.wait(glance);
  }
  return link.newest<Message>()->message;
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
  const std::vector<std::byte> block = LogReader{place, link}.plan_block();
  const core::FlightPlan plan = plan_of(block);
  const std::uint32_t block_crc = protocol::plan_block_crc(block);
  link.listen(place.now());
  const auto heartbeat = next_report<protocol::HeartbeatReport>(place, link, link.count<protocol::HeartbeatReport>());
  if (heartbeat.plan_crc != block_crc) {
    throw LinkError{fmt::format(
        "the plan that was read has block_crc {:08x}, and the avionics reports {:08x}: was a plan sent meanwhile?",
        block_crc, heartbeat.plan_crc)};
  }
  const auto board = next_report<protocol::BoardReport>(place, link, 0);
  return {.plan = plan, .block_crc = block_crc, .source = board.plan};
}

}  // namespace fantail::link
