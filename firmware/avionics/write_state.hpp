// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/autopilot.hpp"
#include "protocol/state_block.hpp"

namespace fantail::avionics {

/// What the flight law remembers, or a part of it, as bytes (protocol::StateWriter). How many the whole has. In a file
/// of its own, because a hundred times a second of a flight asks for speed, and those who call it are compiled for
/// size.
[[nodiscard]] std::size_t write_state(core::Autopilot& law, std::span<std::byte> out, protocol::StateExtent extent,
                                      protocol::StatePart part = {});

/// What its layout is known by: protocol::StateLayout.
[[nodiscard]] std::uint32_t state_layout(core::Autopilot& law);

}  // namespace fantail::avionics
