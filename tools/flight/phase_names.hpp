// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "flight/flight.hpp"

namespace fantail::flight {

/// "Controlling", "control time over", for a reader; core::name() is for files.
[[nodiscard]] std::string display_name(core::Phase phase);
[[nodiscard]] std::string_view display_name(core::PhaseReason reason);

/// "Roll was imposed by the scenario at 0.21 s: angle -0.6 deg, rate 51.8 deg/s." Empty when nothing was imposed.
[[nodiscard]] std::string imposed_roll_sentence(const Flight& flight);

}  // namespace fantail::flight
