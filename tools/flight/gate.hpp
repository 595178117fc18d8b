// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "flight/flight.hpp"

namespace fantail::flight {

/// Does the plan let the canards wait for more than the guide? False where it is not known.
[[nodiscard]] bool has_gate(const Flight& flight);

/// Of a flight in which the canards waited, or whose plan could let them: what a reader has to know of its gate.
[[nodiscard]] bool shows_gate(const Flight& flight);

/// "burn-out", "the largest dynamic pressure", "1500 m", "burn-out and 1500 m"; "the plan's gate" where the plan is not
/// known.
[[nodiscard]] std::string gate_name(const Flight& flight);

/// That it has come: "burn-out detected", "past the largest dynamic pressure", "surely above 1500 m".
[[nodiscard]] std::string gate_has_opened(const Flight& flight);

/// What closes it again: "the motor pushes again", "the dynamic pressure rises again".
[[nodiscard]] std::string gate_has_closed(const Flight& flight);

/// Above the launch site, of a gate by height; empty: it does not wait for one.
[[nodiscard]] std::optional<double> gate_height_m(const Flight& flight);

/// Does the law begin with a whole turn of its own choice?
[[nodiscard]] bool captures(const Flight& flight);

/// That turn: how many whole turns capture put on the plan's reference, by the first row under control, or by the first
/// after the gate reopened, so long after control start. Empty: the law does not capture, or the reference is not
/// known.
[[nodiscard]] std::optional<double> chosen_turn(const Flight& flight, const Row& first_under_control,
                                                double since_control_start_s = 0.0);

}  // namespace fantail::flight
