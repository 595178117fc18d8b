// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "core/flight_plan.hpp"
#include "link/avionics_link.hpp"
#include "link/place.hpp"

namespace fantail::link {

struct PlanInForce {
  core::FlightPlan plan{};
  std::uint32_t block_crc = 0;  ///< protocol::plan_block_crc() of it
  protocol::PlanSource source = protocol::PlanSource::built_in;
};

/// Reads the plan in force back from the avionics, in phase Safe; it needs no session and moves nothing. Whatever is
/// lost or damaged on the way is asked for again. Throws LinkError when the avionics refuses or is silent, and when the
/// plan is not whole, not that of the avionics' heartbeat, or none that this program can read.
[[nodiscard]] PlanInForce read_plan_in_force(Place& place, AvionicsLink& link);

/// Sends a plan block, seven bytes at a time, each waited for, and returns the avionics' last word: stored, when its
/// heartbeat has named the plan as the one in force, or refused.
/// `progress` is called with the bytes that have arrived. Throws LinkError when the avionics does not answer for two
/// seconds, or has written a plan and keeps it back for ten, because a bench session or a self-test is running.
[[nodiscard]] protocol::PlanReply send_plan(Place& place, AvionicsLink& link, std::span<const std::byte> block,
                                            const std::function<void(std::size_t)>& progress);

}  // namespace fantail::link
