// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

namespace fantail::hal {

/// The same type as core::Microseconds, which devices know nothing of.
using Microseconds = std::chrono::duration<std::int64_t, std::micro>;

/// Time since power-up. Never goes backwards.
class Clock {
 public:
  virtual ~Clock() = default;
  /// Two calls may give the same instant.
  [[nodiscard]] virtual Microseconds now() const = 0;
};

}  // namespace fantail::hal
