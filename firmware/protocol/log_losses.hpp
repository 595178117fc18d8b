// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/log_frame.hpp"

namespace fantail::protocol {

// Gaps in a flight log that are not damage.

/// Whether `rest`, all that lies behind the last intact frame of a flight, is what a power cut or the end of a file
/// left of the frame that came next: less than that, or than a page of flash more, because a page that was being
/// written when power went holds anything. Not behind the frame that ends a recording.
[[nodiscard]] bool is_cut_off(const std::optional<LogFrame>& last, std::span<const std::byte> rest);

/// Of the `missing` records before this frame those that the recorder left out, as it says here.
[[nodiscard]] std::uint32_t dropped_before(const LogFrame& frame, std::uint32_t missing);

}  // namespace fantail::protocol
