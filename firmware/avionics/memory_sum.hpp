// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fantail::avionics {

/// Of whole words, as they lie: turned by a bit before each of them, which is then added without carry. Every single
/// bit changes it, and whatever else is wrong in one word. The memory begins at a word. memory_sum.cpp is for every
/// processor, memory_sum_wide.cpp for those that work on four words at once, memory_sum_cortex_m4.cpp for the board's.
[[nodiscard]] std::uint32_t memory_sum(std::span<const std::byte> memory);

}  // namespace fantail::avionics
