// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "board.hpp"
#include "elf.hpp"

namespace fantail::board {

/// Something that ends the program of a board and lets it begin anew.
struct ResetCase {
  std::string_view name;
  std::function<void(Board& board)> happens;
  bool flies_on;  ///< the flight is resumed: the board knows that it has not lost its supply
};

/// Every kind that the processor knows. Throws text::Error when the image has no endless loop to hang in.
[[nodiscard]] std::vector<ResetCase> all_resets(const Image& image);

}  // namespace fantail::board
