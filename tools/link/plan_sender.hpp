// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "link/avionics_link.hpp"
#include "link/place.hpp"

namespace fantail::link {

/// Sends a plan block, seven bytes at a time, each waited for, and returns the avionics' last word: stored, when its
/// heartbeat has named the plan as the one in force, or refused.
/// `progress` is told the bytes that have arrived. Throws LinkError when the avionics does not answer for two seconds,
/// or has written a plan and keeps it back for ten, because somebody has a bench session or a self-test going.
[[nodiscard]] protocol::PlanReply send_plan(Place& place, AvionicsLink& link, std::span<const std::byte> block,
                                            const std::function<void(std::size_t)>& progress);

}  // namespace fantail::link
