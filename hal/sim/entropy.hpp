// SPDX-License-Identifier: MIT
#pragma once

#include "hal/entropy.hpp"

namespace fantail::hal::sim {

/// Always the same number, as from a generator that has failed: a simulated flight has the same bytes every time.
class Entropy final : public hal::Entropy {
 public:
  std::uint32_t draw() override { return 0; }
};

}  // namespace fantail::hal::sim
