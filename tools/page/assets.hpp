// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace fantail::page {

// The files of assets/ and of third_party/uplot, compiled in by embed.cmake.
extern const std::string_view chart_css;  ///< the palette and the drawings
extern const std::string_view page_css;   ///< what stands around them
extern const std::string_view live_js;
extern const std::string_view rocket_js;  ///< fantailRocket(), which scene_js needs
extern const std::string_view
    plot_frame_js;  ///< fantailPlotFrame(), fantailPlotOptions(), for pages that draw plots of their own
extern const std::string_view path_js;   ///< fantailPath(), likewise
extern const std::string_view scene_js;  ///< fantailScene(), which live_js needs where there is a scene
extern const std::string_view uplot_css;
extern const std::string_view uplot_js;
extern const std::string_view uplot_licence;

}  // namespace fantail::page
