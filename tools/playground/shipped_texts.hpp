// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fantail::playground {

/// A file of the project that the module carries with it: "sim/vehicles/smokey.toml".
struct ShippedText {
  std::string_view file;
  std::string_view text;
};

/// Sorted by name. The build writes them (embed_files.cmake).
[[nodiscard]] std::span<const ShippedText> shipped_texts();

/// What stands behind the text of every scenario from now on, as if it were in the file: its faults.
void append_to_scenarios(std::string text);

}  // namespace fantail::playground
