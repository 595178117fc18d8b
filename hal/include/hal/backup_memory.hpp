// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "hal/clock.hpp"

namespace fantail::hal {

/// Memory that a reset of the processor leaves alone and a power cut need not. What lies in it at power-up is anything:
/// seal what is kept here with a CRC.
class BackupMemory {
 public:
  virtual ~BackupMemory() = default;
  /// All of it, to be read and written in place; the same at every call. Empty on a board that has none.
  [[nodiscard]] virtual std::span<std::byte> bytes() = 0;

  /// What a clock in the same domain shows, which a reset leaves alone too: how long one took is seen by it alone.
  /// Counts from anywhere. Empty where none runs, or not yet.
  [[nodiscard]] virtual std::optional<Microseconds> running_time() { return std::nullopt; }
};

}  // namespace fantail::hal
