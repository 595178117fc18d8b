// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "flight/flight.hpp"

namespace fantail::flight {

/// "Controlling", "control time over", for a reader; core::name() is for files.
[[nodiscard]] std::string display_name(core::Phase phase);
[[nodiscard]] std::string_view display_name(core::PhaseReason reason);

/// Why a phase began. What the first moment of a log shows began before it: a recording begins shortly before
/// detection, when the rocket has long been armed.
[[nodiscard]] std::string why_it_began(std::optional<core::PhaseReason> reason, bool is_there_when_log_begins);

/// "Roll was imposed by the scenario at 0.21 s: angle -0.6 deg, rate 51.8 deg/s." Empty when nothing was imposed.
[[nodiscard]] std::string imposed_roll_sentence(const Flight& flight);

}  // namespace fantail::flight
