// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "flight_log/flight_log.hpp"
#include "flight_log/regenerate.hpp"
#include "input/document.hpp"

namespace fantail::flight_log {

/// The plan of a flight with some values changed, for a replay that a person has asked for. Throws text::Error:
/// bad_data when `log`, as the person calls it, holds no plan that can be used; for a change that a replay cannot show;
/// bad_configuration as changed_plan() does.
[[nodiscard]] core::FlightPlan plan_for_replay(const Flight& flight, const std::string& log,
                                               std::span<const input::Override> changes);

/// regenerate(), for which nothing stands in the way. Throws text::Error (bad_data) that says what does.
[[nodiscard]] Regeneration replay(const Flight& flight, const std::string& log, const core::FlightPlan& plan);

}  // namespace fantail::flight_log
