// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fantail::live {

struct PanelWords {
  std::string source{};   ///< where the messages come from
  std::string command{};  ///< that made the page
  std::string version{};
};

/// The whole page; it loads nothing but the frames at /events. The words are escaped.
[[nodiscard]] std::string panel(const PanelWords& words);

}  // namespace fantail::live
