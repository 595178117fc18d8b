// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::report {

/// The letters of a line of the card.
struct Letters {
  double size = 0.0;  ///< of the font, in the units of the picture
  bool bold = false;
};

/// How wide a text becomes in DejaVu Sans, in the units of the picture; rather too much than too little.
[[nodiscard]] double width(std::string_view text, const Letters& letters);

/// A text in lines that are no wider than that. A word wider than a line is cut, between characters; what the most
/// lines do not hold ends with an ellipsis.
[[nodiscard]] std::vector<std::string> in_lines(std::string_view text, const Letters& letters, double most_width,
                                                std::size_t most_lines);

/// What no letter of DejaVu Sans can show, as Chinese, Japanese, Korean and the scripts of India and Thailand.
[[nodiscard]] bool needs_another_font(std::string_view text);

}  // namespace fantail::report
