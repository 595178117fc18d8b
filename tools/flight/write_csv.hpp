// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flight/flight.hpp"

namespace fantail::flight {

/// flight.csv: a header, then one row per tick that was kept, with six decimals. What is unknown is an empty cell. The
/// true_ columns exist when any row has truth, the column `replayed` when any row was not.
[[nodiscard]] std::string csv(const Flight& flight);

/// tunnel.csv: time_s, fan_rpm, wind_speed_m_s; one row per reading of the wind sensor.
[[nodiscard]] std::string tunnel_csv(const Flight& flight);

}  // namespace fantail::flight
