// SPDX-License-Identifier: MIT
#pragma once

#include <string>

// Colours repeat what words say; nothing is said by a colour alone.
namespace fantail::tool {

/// "PASS", "FAIL" and "Outside the model", where a line begins with them.
[[nodiscard]] std::string painted_decision(std::string text);

/// The word behind "phase" where a line begins with that: green while the rocket is safe, yellow while it is armed,
/// cyan in flight.
[[nodiscard]] std::string painted_phase(std::string text);

}  // namespace fantail::tool
