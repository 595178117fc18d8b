// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hal/flash.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::avionics {

/// Where things lie in flash, as addresses. From the bottom, one sector each: plan slots A and B, two of the boot
/// counter; the flight region is the rest. All of it follows from the geometry alone.
struct FlashMap {
  std::array<std::uint32_t, 2> plan_slots{};
  std::array<std::uint32_t, 2> boot_sectors{};
  std::uint32_t flight_begin = 0;
  std::uint32_t flight_end = 0;
  std::uint32_t sector_size = 0;
  std::uint32_t page_size = 0;

  [[nodiscard]] constexpr std::uint32_t flight_sectors() const { return (flight_end - flight_begin) / sector_size; }
};

/// The smallest thing that is programmed at once and must not cross a page: the header of a plan slot.
inline constexpr std::uint32_t smallest_page = 16;

/// Empty when the flash cannot hold all of this: a plan slot is a page of header and the pages of the largest block,
/// and there is at least one sector for flights.
[[nodiscard]] constexpr std::optional<FlashMap> flash_map(const hal::FlashGeometry& flash) {
  const std::uint64_t page = flash.page_size;
  const std::uint64_t sector = flash.sector_size;
  if (page == 0 || page % smallest_page != 0 || sector == 0 || sector % page != 0 || flash.size % sector != 0) {
    return std::nullopt;
  }
  const std::uint64_t block_pages = (protocol::largest_plan_block + page - 1) / page;
  if (page * (1 + block_pages) > sector || flash.size / sector < 5) {
    return std::nullopt;
  }
  const std::uint32_t size = flash.sector_size;
  return FlashMap{.plan_slots = {0, size},
                  .boot_sectors = {2 * size, 3 * size},
                  .flight_begin = 4 * size,
                  .flight_end = flash.size,
                  .sector_size = size,
                  .page_size = flash.page_size};
}

}  // namespace fantail::avionics
