// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "avionics/flash_map.hpp"
#include "core/time.hpp"
#include "hal/flash.hpp"

namespace fantail::avionics {

enum class Access : std::uint8_t {
  done,   ///< read: done. program, erase: begun
  again,  ///< the flash is busy; ask again in the next tick
  failed,
};

/// The flash as its users here see it: one that nobody ever waits for, and that fails when it has been busy for too
/// long. A user tries one call a tick; the device itself says busy until what was begun before has ended, and so a read
/// that is done proves that the program before it has ended too.
class FlashAccess {
 public:
  /// W25Q128: an erase takes 400 ms at worst.
  static constexpr core::Microseconds patience{2'000'000};
  /// What may be read in one tick.
  static constexpr std::size_t read_size = 256;

  /// The flash outlives this object. With one that is too small, or whose geometry makes no sense, every call fails.
  explicit FlashAccess(hal::Flash& flash) : FlashAccess{flash, flash_map(flash.geometry())} {}

  /// Of zeros when every call fails.
  [[nodiscard]] const FlashMap& map() const { return map_; }

  Access read(core::Microseconds now, std::uint32_t address, std::span<std::byte> out) {
    return usable_ ? judge(now, flash_.read(address, out)) : Access::failed;
  }
  Access program(core::Microseconds now, std::uint32_t address, std::span<const std::byte> bytes) {
    return usable_ ? judge(now, flash_.program(address, bytes)) : Access::failed;
  }
  Access erase_sector(core::Microseconds now, std::uint32_t address) {
    return usable_ ? judge(now, flash_.erase_sector(address)) : Access::failed;
  }

 private:
  FlashAccess(hal::Flash& flash, const std::optional<FlashMap>& map)
      : flash_{flash}, map_{map.value_or(FlashMap{})}, usable_{map.has_value()} {}

  Access judge(core::Microseconds now, hal::FlashResult result) {
    if (result != hal::FlashResult::busy) {
      busy_since_.reset();
      return result == hal::FlashResult::ok ? Access::done : Access::failed;
    }
    if (!busy_since_) {
      busy_since_ = now;
    }
    return now - *busy_since_ > patience ? Access::failed : Access::again;
  }

  hal::Flash& flash_;
  FlashMap map_;
  bool usable_;
  std::optional<core::Microseconds> busy_since_;
};

}  // namespace fantail::avionics
