// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::files {

struct BlueRavenTable {
  std::string text{};                ///< a table as the app of the Blue Raven exports it
  std::vector<std::string> notes{};  ///< a sentence each
};

/// The text that a Blue Raven itself writes, record by record ("@ LOG_HIR ..." or "@ LOG_LOW ..."), with the names,
/// units and scales of the app's export; its time begins with the first record. Broken records are left out, and noted.
/// Empty: it is no such text. Scales: its USB guide, June 2023.
[[nodiscard]] std::optional<BlueRavenTable> blue_raven_table(std::string_view text);

}  // namespace fantail::files
