// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "logs/roll_log.hpp"
#include "sim/atmosphere.hpp"

namespace fantail::identify {

/// Which air a log was flown in, and in words.
struct Air {
  sim::Atmosphere atmosphere{};
  std::string words{};
};

/// `asked` is a density in kg/m3, "exponential" or "isa". Empty: exponential when the log climbs, else 1.2 kg/m3.
/// Throws sim::InputError (bad_configuration) for anything else.
[[nodiscard]] Air choose_air(const logs::RollLog& log, const std::optional<std::string>& asked);

}  // namespace fantail::identify
