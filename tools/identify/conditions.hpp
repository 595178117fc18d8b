// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identify/study.hpp"

namespace fantail::identify {

// What changes over a flight while a model holds it constant, or counts with it.

/// A vehicle's roll inertia since ignition, put on the log's clock by the burn-out that the log shows. Empty where it
/// shows none; `warnings` then says that the inertia at lift-off is used.
[[nodiscard]] sim::RollInertiaCourse inertia_on_clock(const logs::RollLog& log,
                                                      const sim::RollInertiaCourse& since_ignition,
                                                      std::vector<std::string>& warnings);

/// Which roll inertia a window was identified with, where it is not the same throughout the flight.
[[nodiscard]] std::optional<std::string> remark_on_inertia(const model::Record& record,
                                                           const sim::RollInertiaCourse& course);

/// How much alpha and beta change with the Mach number within a window, where that is worth a word.
[[nodiscard]] std::optional<std::string> remark_on_mach(const logs::RollLog& log, const model::Record& record,
                                                        const Question& question);

}  // namespace fantail::identify
