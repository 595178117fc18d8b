// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "core/time.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::avionics {

/// A flight is recorded for so long after control has ended.
inline constexpr core::Microseconds recorded_after_control{30'000'000};

/// What the flash told about itself.
struct FlashFacts {
  bool has_bad_pages = false;                  ///< of the flights': passed over
  bool failed = false;                         ///< it does not answer, or this power-up could not be counted in it
  std::optional<protocol::PlanSource> plan{};  ///< the one in force; empty until the flash has been asked
  std::optional<std::uint32_t> free_bytes{};   ///< for the record of the flight; empty until counted
  std::uint32_t region_bytes = 0;              ///< all there is for it

  /// Nothing about the flash keeps the rocket from being armed, as far as is known yet.
  [[nodiscard]] bool fit() const {
    return !failed && (!plan || plan == protocol::PlanSource::built_in || plan == protocol::PlanSource::stored);
  }
};

}  // namespace fantail::avionics
