// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tunnel/swirl.hpp"

namespace fantail::tunnel {

// What `fantail tunnel swirl` says, three times: for the terminal, for a script, and as a page with pictures.

struct SwirlSessions {
  RollSession without;  ///< flow straightener
  RollSession with;
};

/// One sentence: what the swirl is worth.
[[nodiscard]] std::string swirl_sentence(const Swirl& swirl);

[[nodiscard]] std::string swirl_text(const SwirlSessions& sessions, const Swirl& swirl);
[[nodiscard]] std::string swirl_json(const SwirlSessions& sessions, const Swirl& swirl);
[[nodiscard]] std::string swirl_html(const SwirlSessions& sessions, const Swirl& swirl);

}  // namespace fantail::tunnel
