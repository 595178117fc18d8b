// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "live/server.hpp"

namespace fantail::live {

struct PanelWords {
  std::string source{};   ///< where the messages come from
  std::string command{};  ///< that made the page
  std::string version{};
};

/// The whole page of a rocket that is heard; it loads nothing but the frames at /events (Feed). The words are escaped.
[[nodiscard]] Page panel(const PanelWords& words);
/// The same of the sheet of a bench, which fills while canards move (SheetFeed).
[[nodiscard]] Page sheet_panel(const PanelWords& words);

}  // namespace fantail::live
