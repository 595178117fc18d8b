// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "avionics/flash_access.hpp"
#include "core/time.hpp"

namespace fantail::avionics {

/// Counts power-ups in flash, from 1. No count is ever handed out twice, wherever the power was cut: it is there only
/// when it has been written and read back, and a record that cannot be read may have held one.
///
/// Records of 8 bytes (count, CRC-32C) fill one sector and then the other; a sector is erased just before its first
/// record is written, and the record before that stays in the other one. A sector that looks blank is not trusted to be
/// so, because an erase that was cut can leave cells that read as ones and do not last.
class BootCounter {
 public:
  /// The access outlives this object.
  explicit BootCounter(FlashAccess& flash) : flash_{flash} {}

  /// Once a tick until it has finished: at most one call to the flash.
  void update(core::Microseconds now);

  /// It no longer needs the flash.
  [[nodiscard]] bool finished() const { return step_ == Step::done || step_ == Step::failed; }
  /// The flash does not answer, or does not hold what was written.
  [[nodiscard]] bool failed() const { return step_ == Step::failed; }
  /// This power-up's own; empty until it lies in flash.
  [[nodiscard]] std::optional<std::uint32_t> count() const;

 private:
  enum class Step : std::uint8_t { scan, erase, program, check, done, failed };
  struct Sector {
    std::uint32_t highest = 0;             ///< count; 0: no record can be read
    std::uint32_t unreadable = 0;          ///< slots in use after that one; each may have held a higher count
    std::optional<std::uint32_t> blank{};  ///< offset of the first one after it
  };

  [[nodiscard]] bool done(Access access);
  void scan(core::Microseconds now);
  void look_at(Sector& sector, std::uint32_t offset, std::span<const std::byte> records);
  void choose();
  void check(core::Microseconds now);

  FlashAccess& flash_;
  Step step_ = Step::scan;
  std::array<Sector, 2> sectors_{};
  std::size_t sector_ = 0;  ///< that is scanned, and later written
  std::uint32_t offset_ = 0;
  std::uint32_t count_ = 0;
  int spoilt_ = 0;  ///< slots that did not keep what was written
};

}  // namespace fantail::avionics
