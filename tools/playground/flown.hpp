// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::playground {

/// A flight as a page shows it.
struct Flown {
  std::string summary{};         ///< summary.json, as fantail fly writes it
  std::vector<float> columns{};  ///< one behind the other, each `rows` long: see column_names()
  std::size_t rows = 0;
};

/// "time_s roll_deg ...", in the order of Flown::columns. What is not there is NaN.
[[nodiscard]] std::string_view column_names();

/// Flies as `words` request: the name of a shipped scenario on the first line, and on each line that follows one
/// setting, section.key=value as in fantail fly --set, or seed=7. Settings of the section `faults` together are one
/// fault, of that scenario: faults.kind="canard_stuck". Throws text::Error with a sentence for the viewer.
[[nodiscard]] Flown fly(std::string_view words);

}  // namespace fantail::playground
