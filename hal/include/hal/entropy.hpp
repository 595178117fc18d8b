// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::hal {

/// Numbers that nobody can foretell, from noise in the hardware.
class Entropy {
 public:
  virtual ~Entropy() = default;
  /// Never waits. A generator that has failed may repeat itself, so nobody may rely on numbers that differ.
  virtual std::uint32_t draw() = 0;
};

}  // namespace fantail::hal
