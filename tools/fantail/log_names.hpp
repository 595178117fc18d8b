// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace fantail::tool {

/// How two logs are called where a person reads of them.
struct LogNames {
  std::string a;
  std::string b;
};

struct NamedMotion {
  std::filesystem::path path;
  std::string motion{};  ///< "measured", "true"
};

/// Their file names, or where those are equal the folders before them, too; behind them the motions, where those
/// differ. The same motion of the same file: "flight.csv (first)".
[[nodiscard]] LogNames distinct_names(const NamedMotion& a, const NamedMotion& b);

}  // namespace fantail::tool
