// SPDX-License-Identifier: MIT
#include "avionics/memory_watch.hpp"

#include <algorithm>
#include <span>

#include "avionics/memory_sum.hpp"
#include "protocol/crc32c.hpp"

namespace fantail::avionics {
namespace {

constexpr std::size_t slice = 16;
static_assert(sizeof(core::FlightPlan) <= 40 * slice, "all of it within 40 ms");

std::span<const std::byte> bytes_of(const core::FlightPlan& plan) { return std::as_bytes(std::span{&plan, 1}); }

}  // namespace

void MemoryWatch::begin(const core::FlightPlan& plan) {
  *this = {};
  plan_crc_ = protocol::crc32c(bytes_of(plan));
}

// Meets MEM-4.
bool MemoryWatch::intact(const core::Autopilot& law) const {
  return !damaged_ && (!law_ || *law_ == memory_sum(law.flight_memory()));
}

void MemoryWatch::look(const core::FlightPlan& plan, const core::Autopilot& law) {
  // Its own numbers may be damaged too.
  const std::size_t looked_at = std::min<std::size_t>(looked_at_, sizeof plan);
  const auto rest = bytes_of(plan).subspan(looked_at);
  const auto next = rest.first(std::min(slice, rest.size()));
  crc_so_far_ = protocol::crc32c(crc_so_far_, next);
  looked_at_ = static_cast<std::uint16_t>(looked_at + next.size());
  if (next.size() == rest.size()) {
    damaged_ = damaged_ || crc_so_far_ != plan_crc_;
    looked_at_ = 0;
    crc_so_far_ = 0;
  }
  damaged_ = damaged_ || !law.moves_as_planned(canard_ % core::canard_count, plan);
  canard_ = static_cast<std::uint8_t>(canard_ + 1U);
  law_ = core::is_flight(law.phase()) ? std::optional{memory_sum(law.flight_memory())} : std::nullopt;
}

}  // namespace fantail::avionics
