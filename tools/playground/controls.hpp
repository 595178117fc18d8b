// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fantail::playground {

/// The controls of a page for this scenario, as JSON: {"surroundings", "controls": [{"key", "label", "unit",
/// "value", "low", "high", "step", "meaning"}, ...], "faults": [{"kind", "meaning", "fields": [{"key",
/// "unit", "meaning"}, ...]}, ...]}. Throws text::Error.
[[nodiscard]] std::string controls(const std::string& scenario);

/// The shipped scenarios, one a line, an empty line, and the columns of a flight.
[[nodiscard]] std::string names();

}  // namespace fantail::playground
