// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "live/server.hpp"

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

struct PanelWords {
  std::string source{};   ///< where the messages come from
  std::string command{};  ///< that made the page
  std::string version{};
};

/// The whole page of a rocket; it loads only the frames at /events (Feed). The words are escaped.
[[nodiscard]] Page panel(const PanelWords& words);
/// The same of the sheet of a bench, which fills while canards move (SheetFeed).
[[nodiscard]] Page sheet_panel(const PanelWords& words);

}  // namespace fantail::live
