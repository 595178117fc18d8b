// SPDX-License-Identifier: MIT
#include "avionics/flash_room.hpp"

#include <array>
#include <cstddef>

#include "avionics/sealed_words.hpp"

namespace fantail::avionics {

void FlashRoom::update(core::Microseconds now) {
  if (finished()) {
    return;
  }
  const FlashMap map = flash_.map();
  std::array<std::byte, smallest_page> first{};
  const Access access = flash_.read(now, map.flight_begin + looked_at_ * map.sector_size, first);
  failed_ = access == Access::failed;
  if (access == Access::done) {
    blank_ += erased(first) ? 1 : 0;
    looked_at_ += 1;
  }
}

std::optional<std::uint32_t> FlashRoom::free_bytes() const {
  const FlashMap map = flash_.map();
  if (looked_at_ == 0 || looked_at_ < map.flight_sectors()) {
    return std::nullopt;
  }
  return blank_ * map.sector_size;
}

}  // namespace fantail::avionics
