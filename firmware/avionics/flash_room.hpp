// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "avionics/flash_access.hpp"
#include "core/time.hpp"

namespace fantail::avionics {

/// How much of the flight region is free: looks at the beginning of one sector a tick, 4 s for 16 MiB. A sector that
/// begins blank counts as free, since whoever fills one begins at its beginning.
class FlashRoom {
 public:
  /// The access outlives this object.
  explicit FlashRoom(FlashAccess& flash) : flash_{flash} {}

  /// Once a tick until it has finished: at most one call to the flash.
  void update(core::Microseconds now);

  [[nodiscard]] bool finished() const { return failed_ || free_bytes(); }
  /// The flash does not answer.
  [[nodiscard]] bool failed() const { return failed_; }
  /// At the time of the scan; empty until the whole region has been looked at.
  [[nodiscard]] std::optional<std::uint32_t> free_bytes() const;

 private:
  FlashAccess& flash_;
  std::uint32_t looked_at_ = 0;  ///< sectors
  std::uint32_t blank_ = 0;      ///< sectors
  bool failed_ = false;
};

}  // namespace fantail::avionics
