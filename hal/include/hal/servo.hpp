// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace fantail::hal {

/// As many as core::canard_count, and in the same order.
inline constexpr std::size_t canards = 4;

/// Width of a servo pulse.
using Pulse = std::chrono::duration<std::int32_t, std::nano>;

/// The four canard servos; one write updates all of them in the same pulse frame.
class Servo {
 public:
  virtual ~Servo() = default;
  /// An empty pulse switches that output off: the servo is not driven. Outputs are off at power-up.
  virtual void write(const std::array<std::optional<Pulse>, canards>& pulses) = 0;
};

}  // namespace fantail::hal
