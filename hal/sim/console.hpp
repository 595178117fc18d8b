// SPDX-License-Identifier: MIT
#pragma once

#include "hal/console.hpp"

namespace fantail::hal::sim {

/// Discards all text.
class Console final : public hal::Console {
 public:
  void write(std::string_view /*text*/) override {}
};

}  // namespace fantail::hal::sim
