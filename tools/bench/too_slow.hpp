// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace fantail::bench {

/// What was recorded says nothing of the canards, because this PC read late or lost frames. what() says it for a
/// person.
class TooSlow : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fantail::bench
