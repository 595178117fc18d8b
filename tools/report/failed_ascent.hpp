// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flight/flight.hpp"
#include "json/value.hpp"

namespace fantail::report {

/// What became of a rocket before its motor had burnt out, sentence by sentence: first that it turned over, then all
/// else in the order of time. Empty: nothing did.
[[nodiscard]] std::string before_burnout(const flight::Flight& flight);

/// As summary.json has it; null where nothing happened.
[[nodiscard]] json::Value before_burnout_json(const flight::Flight& flight);

/// The other way.
[[nodiscard]] std::optional<flight::BeforeBurnout> read_before_burnout(const json::Value& json);

}  // namespace fantail::report
