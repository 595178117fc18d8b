// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "elf.hpp"
#include "processor.hpp"

namespace fantail::board {

struct ImageIdentity {
  std::string version;
  std::string git_hash;
};

/// What an image says of itself in its first line: "Fantail 0.2.0, git 0123456789ab". Throws text::Error when it says
/// no such thing soon after power-up.
[[nodiscard]] ImageIdentity identity_of(const Image& image, const Pace& pace);

}  // namespace fantail::board
