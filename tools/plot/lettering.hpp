// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fantail::plot {

/// How wide the text stands in the drawing's own units, rather too much than too little: nobody knows the reader's
/// font.
[[nodiscard]] double text_width(std::string_view text);

/// As much of the text as fits, with an ellipsis when that is not all.
[[nodiscard]] std::string shortened(std::string_view text, double width);

/// Escaped, with real minus signs.
[[nodiscard]] std::string printed(std::string_view text);

}  // namespace fantail::plot
