// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace fantail::tool {

/// Does this program make of what a board has recorded what the board has made of it?
struct BoardReplay {
  std::string note;  ///< a sentence for the page
  bool differs = false;
};

/// Of every flight in `log`, the content of its flash. Throws text::Error when it is no log.
[[nodiscard]] BoardReplay board_replay(std::span<const std::byte> log);

}  // namespace fantail::tool
