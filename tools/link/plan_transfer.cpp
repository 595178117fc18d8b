// SPDX-License-Identifier: MIT
#include "link/plan_transfer.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "avionics/can_frame.hpp"
#include "link/log_reader.hpp"
#include "link/session.hpp"
#include "protocol/plan_block.hpp"
#include "replies/sentence.hpp"

namespace fantail::link {
namespace {

using hal::Microseconds;
using protocol::TransferState;

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
    throw LinkError{"the avionics sent a plan that this program cannot read: " + replies::sentence(why)};
  }
  return *reading.plan;
}

constexpr std::size_t bytes_per_frame = std::tuple_size_v<decltype(protocol::PlanData::bytes)>;
constexpr Microseconds repeat_after{50'000};
constexpr Microseconds answer_time{2'000'000};
// Longer than the slowest flash needs.
constexpr Microseconds write_time{10'000'000};
// The bus load allows for one data frame in ten milliseconds.
constexpr Microseconds pace{10'000};
constexpr int heartbeats_asked = 5;
constexpr Microseconds in_force_time{3'000'000};

protocol::BusFrame data_frame(std::span<const std::byte> block, std::size_t index) {
  protocol::PlanData data{.index = static_cast<std::uint8_t>(index)};
  const auto rest = block.subspan(std::min(index * bytes_per_frame, block.size()));
  std::ranges::copy(rest.first(std::min(rest.size(), bytes_per_frame)), data.bytes.begin());
  return encode(data);
}

// Its heartbeat names it, as often as it takes to hear a second rocket.
void expect_in_force(Place& place, AvionicsLink& link, std::uint32_t block_crc) {
  std::uint64_t seen = link.count<protocol::HeartbeatReport>();
  int named = 0;
  for (Timeout timeout{in_force_time, place.now()}; named < heartbeats_asked;) {
    if (timeout.expired(place.now())) {
      throw LinkError{
          "the avionics has stored the plan, but its heartbeat names another one: `fantail bench plan show` reads the "
          "one in force"};
    }
    place.wait(Microseconds{2'000});
    link.listen(place.now());
    link.expect_one_rocket();
    if (const std::uint64_t now_seen = link.count<protocol::HeartbeatReport>(); now_seen != seen) {
      seen = now_seen;
      named = link.reported<protocol::HeartbeatReport>("heartbeat").plan_crc == block_crc ? named + 1 : 0;
    }
  }
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

protocol::PlanReply send_plan(Place& place, AvionicsLink& link, std::span<const std::byte> block,
                              const std::function<void(std::size_t)>& progress) {
  const auto heard = [&] {
    link.listen(place.now());
    link.expect_one_rocket();
    return link.count<protocol::PlanReply>();
  };
  const protocol::PlanBegin begin{.size = static_cast<std::uint16_t>(block.size()),
                                  .block_crc = protocol::plan_block_checksum(block)};
  std::uint64_t seen = heard();
  protocol::FrameCounter counter;
  std::optional<std::size_t> next;  // empty: it has not yet answered the beginning
  std::optional<Timeout> writing;
  Timeout answer{answer_time, place.now()};
  Microseconds send_at = place.now();
  while (true) {
    if (place.now() >= send_at) {
      const bool complete = next && *next * bytes_per_frame >= block.size();
      if (!complete) {
        const protocol::BusFrame frame = next ? data_frame(block, *next) : encode(begin, counter.next());
        (void)place.bus().send(avionics::can_frame(frame));
      }
      send_at = place.now() + repeat_after;
    }
    place.wait(Microseconds{2'000});
    if (const std::uint64_t now_seen = heard(); now_seen != seen) {
      seen = now_seen;
      answer.restart();
      const protocol::PlanReply reply = link.reported<protocol::PlanReply>("plan transfer");
      // Until it has taken this beginning, what it writes and stores is the plan of a bench that was here before.
      const bool stored_this = reply.state == TransferState::stored && next;
      if (stored_this) {
        expect_in_force(place, link, begin.block_crc);
      }
      if (stored_this || reply.state == TransferState::refused) {
        return reply;
      }
      if (reply.state != TransferState::writing) {
        writing.reset();
      } else if (!writing) {
        writing.emplace(write_time, place.now());
      }
      if (reply.state == TransferState::receiving && next != reply.next_index) {
        next = reply.next_index;
        send_at = std::min(send_at, place.now() + pace);
        progress(std::min(*next * bytes_per_frame, block.size()));
      }
    }
    if (writing && writing->expired(place.now())) {
      throw LinkError{
          "the avionics has written the plan but does not use it yet. It comes into force when the phase is Safe and "
          "no bench session or self-test is running"};
    }
    if (answer.expired(place.now())) {
      throw LinkError{"the avionics does not answer; its old plan stays in force"};
    }
  }
}

}  // namespace fantail::link
