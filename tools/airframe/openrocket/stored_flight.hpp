// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <pugixml.hpp>

#include "airframe/openrocket/read.hpp"

namespace fantail::airframe::openrocket {

/// The flights that OpenRocket has simulated and stored with a design. Those that are out of date, were broken off or
/// have no series of numbers are left out; so is every number that is none, and a centre of pressure beyond Mach 0.5
/// or 5 degrees of angle of attack.
[[nodiscard]] std::vector<StoredFlight> stored_flights(pugi::xml_node simulations, std::vector<std::string>& not_used);

}  // namespace fantail::airframe::openrocket
