// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace fantail::hal {

/// Lines for a person with a serial cable.
class Console {
 public:
  virtual ~Console() = default;
  /// Never waits; what does not fit into the queue is dropped.
  virtual void write(std::string_view text) = 0;
};

}  // namespace fantail::hal
