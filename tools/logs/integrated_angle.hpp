// SPDX-License-Identifier: MIT
#pragma once

#include "flight/table.hpp"
#include "logs/roll_log.hpp"

namespace fantail::logs {

/// Is there a column for the roll angle, or one that is likely meant to be it? An angle under a misspelt name must not
/// be replaced without a question.
[[nodiscard]] bool may_have_roll_angle(const flight::Table& table, const flight::Reading& reading);

/// Makes the roll angle the integral of the roll rate, zero at the first sample, and adds a warning that says so.
void integrate_roll_rate(RollLog& log, const flight::Reading& reading);

}  // namespace fantail::logs
