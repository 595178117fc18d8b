// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

namespace fantail::tool {

/// Ctrl-C, a request to terminate, or a terminal that was closed. Work is given up between two steps, never in the
/// middle of writing results.
class Interrupted : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "interrupted; nothing was written"; }
};

/// From here on the signals only set a mark.
void catch_interrupts();

/// Throws Interrupted when the mark is set.
void give_up_if_interrupted();

}  // namespace fantail::tool
