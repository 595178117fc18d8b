// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/flight_plan.hpp"
#include "proof.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::avionics {

enum class PlanWrite : std::uint8_t { none, under_way, stored, flash_failed, read_back_differs };

inline int writes_begun = 0;

/// In the place of the two slots in the flash: how a write goes is any of what it can be. Counts those that were begun.
class PlanStore {
 public:
  void begin_write(std::span<const std::byte>) { writes_begun += 1; }
  bool withdraw() { return nondet_bool(); }
  [[nodiscard]] PlanWrite write() const { return proof::any_of<PlanWrite>(5); }
};

}  // namespace fantail::avionics
