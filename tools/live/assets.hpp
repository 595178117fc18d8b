// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace fantail::live {

// The files of assets/, compiled in by embed.cmake.
extern const std::string_view panel_html;  ///< with {names} in place of what panel.cpp puts there
extern const std::string_view end_html;    ///< with which both pages end
extern const std::string_view panel_css;
extern const std::string_view panel_js;
extern const std::string_view sheet_html;
extern const std::string_view sheet_css;
extern const std::string_view sheet_js;
extern const std::string_view live_js;  ///< of both pages

}  // namespace fantail::live
