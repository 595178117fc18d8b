// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::hal {

/// Unpredictable numbers, from noise in the hardware.
class Entropy {
 public:
  virtual ~Entropy() = default;
  /// Never waits. A generator that has failed may repeat itself, so do not rely on numbers that differ.
  virtual std::uint32_t draw() = 0;
};

}  // namespace fantail::hal
