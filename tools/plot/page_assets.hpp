// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace fantail::plot {

extern const std::string_view plot_css;  ///< page/plot.css: the palette and the drawings
extern const std::string_view page_css;  ///< page/page.css: what stands around them

}  // namespace fantail::plot
