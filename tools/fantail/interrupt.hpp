// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "text/error.hpp"

namespace fantail::tool {

/// Ctrl-C, a request to terminate, or a terminal that was closed. Work is given up between two steps, never in the
/// middle of writing results.
class Interrupted : public text::Error {
 public:
  explicit Interrupted(const std::string& what = "interrupted; nothing was written")
      : Error{text::ErrorKind::interrupted, what} {}
};

/// From here on the signals only set a mark.
void catch_interrupts();

/// For a program that takes the signals itself: called wherever the mark is looked at, it throws when there was one.
void ask_for_interrupts(void (*give_up)());

/// Throws Interrupted when the mark is set.
void give_up_if_interrupted();

/// True once for every interrupt: for work that has to be ended in order, and cannot when the mark stays.
[[nodiscard]] bool take_interrupt();

}  // namespace fantail::tool
