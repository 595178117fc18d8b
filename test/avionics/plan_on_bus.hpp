// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "avionics/board_rig.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::avionics {

/// As a bench does it, a piece a tick.
inline void send_plan(BoardRig& rig, const core::FlightPlan& plan) {
  std::array<std::byte, protocol::largest_plan_block> buffer{};
  const auto block = std::span{buffer}.first(protocol::write_plan_block(plan, buffer));
  rig.pc.say(protocol::PlanBegin{.size = static_cast<std::uint16_t>(block.size()),
                                 .block_crc = protocol::plan_block_crc(block)});
  rig.tick();
  for (std::size_t at = 0; at < block.size(); at += 7) {
    protocol::PlanData data{.index = static_cast<std::uint8_t>(at / 7)};
    std::ranges::copy(block.subspan(at, std::min<std::size_t>(7, block.size() - at)), data.bytes.begin());
    rig.pc.say(data);
    rig.tick();
  }
}

}  // namespace fantail::avionics
