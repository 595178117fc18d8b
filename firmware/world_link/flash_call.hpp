// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::world_link {

/// What a flight computer asks of the world's flash.
enum class FlashCall : std::uint8_t { read, program, erase, busy };

}  // namespace fantail::world_link
