// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "link/log_download.hpp"

namespace fantail::link {

/// What a second look at a downloaded stretch has found.
struct LogCheck {
  std::uint32_t mended_bytes = 0;    ///< were not as the avionics has them, and now are
  std::uint32_t unsteady_bytes = 0;  ///< in chunks that were read differently each time
  bool intact = false;               ///< every record is there, by its CRC-32C and its number, up to a last cut-off one
  /// All that is on this PC is what the avionics has: each byte stands under the CRC-32C of its record, or two fetches
  /// of it agree. What is not intact then is damaged in the flash.
  [[nodiscard]] bool agrees() const { return unsteady_bytes == 0; }
};

/// Verifies a part that holds the whole stretch, and fetches again what fails. Of the first `resumed_bytes`, which this
/// run did not fetch, everything that no intact record covers is fetched again. If a flight is not whole then, so is
/// the whole stretch: only two fetches that agree make it damage in the flash, or a record that was cut off there.
/// `progress` is told the bytes fetched again; it may throw to give up, and the part stays.
[[nodiscard]] LogCheck verify(LogReader& reader, const LogStretch& stretch, LogPart& part, std::uint32_t resumed_bytes,
                              const std::function<void(std::uint32_t)>& progress);

}  // namespace fantail::link
