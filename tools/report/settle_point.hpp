// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flight/flight.hpp"

namespace fantail::report {

/// Where the law of the plan comes to rest: "R + u_d/kp".
[[nodiscard]] std::string settle_point_name(const flight::Flight& flight);

/// Why it comes to rest there, with this flight's own numbers where they are known.
[[nodiscard]] std::string settle_point_text(const flight::Flight& flight);

}  // namespace fantail::report
