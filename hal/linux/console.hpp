// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hal/console.hpp"

namespace fantail::hal::on_linux {

/// Standard error. What a pipe or a terminal has no room for right now is dropped, and so is everything after its
/// reader has gone: whoever owns the process must ignore SIGPIPE for that.
class Console final : public hal::Console {
 public:
  void write(std::string_view text) override;
};

}  // namespace fantail::hal::on_linux
