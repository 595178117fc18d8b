// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "hal/flash.hpp"

namespace fantail::hal {

/// A sector is a whole number of pages, the flash a whole number of sectors, and none of them is nothing.
[[nodiscard]] constexpr bool sensible(const FlashGeometry& geometry) {
  return geometry.page_size > 0 && geometry.sector_size > 0 && geometry.size > 0 &&
         geometry.sector_size % geometry.page_size == 0 && geometry.size % geometry.sector_size == 0;
}

/// What NOR flash does to its cells, for every backend that keeps them in memory. Knows no time: each call is done when
/// it returns, so it never says busy. With a geometry that is not sensible, or that is not the size of the cells, every
/// call is out of range.
class NorMemory {
 public:
  /// The cells outlive this object.
  NorMemory(std::span<std::byte> cells, const FlashGeometry& geometry)
      : cells_{cells}, geometry_{sensible(geometry) && cells.size() == geometry.size ? geometry : FlashGeometry{}} {}

  // Would the call be done? For a device that does it later.
  [[nodiscard]] FlashResult may_read(std::uint32_t address, std::size_t size) const {
    return inside(address, size) ? FlashResult::ok : FlashResult::out_of_range;
  }
  /// Within one page.
  [[nodiscard]] FlashResult may_program(std::uint32_t address, std::size_t size) const {
    // Before the remainder is taken: an unusable geometry has pages of no size.
    const bool fits = inside(address, size) && address % geometry_.page_size + size <= geometry_.page_size;
    return fits ? FlashResult::ok : FlashResult::out_of_range;
  }
  /// `address` must be where a sector begins.
  [[nodiscard]] FlashResult may_erase(std::uint32_t address) const {
    const bool fits = address < geometry_.size && address % geometry_.sector_size == 0;
    return fits ? FlashResult::ok : FlashResult::out_of_range;
  }

  /// All of `out`, or nothing of it.
  FlashResult read(std::uint32_t address, std::span<std::byte> out) const {
    const FlashResult result = may_read(address, out.size());
    if (result == FlashResult::ok) {
      std::ranges::copy(cells_.subspan(address, out.size()), out.begin());
    }
    return result;
  }

  /// Each byte becomes the AND of old and new: all of them, or none.
  FlashResult program(std::uint32_t address, std::span<const std::byte> bytes) {
    const FlashResult result = may_program(address, bytes.size());
    if (result == FlashResult::ok) {
      clear_bits(cells_.subspan(address, bytes.size()), bytes);
    }
    return result;
  }

  /// All bytes of the sector become 0xFF.
  FlashResult erase_sector(std::uint32_t address) {
    const FlashResult result = may_erase(address);
    if (result == FlashResult::ok) {
      std::ranges::fill(cells_.subspan(address, geometry_.sector_size), std::byte{0xFF});
    }
    return result;
  }

 private:
  /// By words, as far as they go: every simulated flight is recorded.
  static void clear_bits(std::span<std::byte> cells, std::span<const std::byte> bytes) {
    std::size_t i = 0;
    for (std::uint64_t cell = 0, byte = 0; i + sizeof cell <= bytes.size(); i += sizeof cell) {
      std::memcpy(&cell, cells.data() + i, sizeof cell);
      std::memcpy(&byte, bytes.data() + i, sizeof byte);
      cell &= byte;
      std::memcpy(cells.data() + i, &cell, sizeof cell);
    }
    for (; i < bytes.size(); ++i) {
      cells[i] &= bytes[i];
    }
  }

  [[nodiscard]] bool inside(std::uint32_t address, std::size_t size) const {
    return address < geometry_.size && size <= geometry_.size - address;
  }

  std::span<std::byte> cells_;
  FlashGeometry geometry_;
};

}  // namespace fantail::hal
