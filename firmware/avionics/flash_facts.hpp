// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "core/time.hpp"

namespace fantail::avionics {

/// A flight is recorded for so long after control has ended.
inline constexpr core::Microseconds recorded_after_control{30'000'000};

/// What the flash told about itself.
struct FlashFacts {
  bool failed = false;                        ///< it does not answer, or this power-up could not be counted in it
  bool stored_plan_broken = false;            ///< a plan was stored and none can be read
  std::optional<std::uint32_t> free_bytes{};  ///< for the record of the flight; empty until counted
  std::uint32_t region_bytes = 0;             ///< all there is for it
};

}  // namespace fantail::avionics
