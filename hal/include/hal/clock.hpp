// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

namespace fantail::hal {

using Microseconds = std::chrono::duration<std::int64_t, std::micro>;

/// Time since power-up. Never goes backwards.
class Clock {
 public:
  virtual ~Clock() = default;
  [[nodiscard]] virtual Microseconds now() const = 0;
};

}  // namespace fantail::hal
