// SPDX-License-Identifier: MIT
#pragma once

#include "identify/model/roll_model.hpp"
#include "identify/result/findings.hpp"

namespace fantail::identify::result {

/// Is the residual of the roll rate white, and has it to do with the canards? A right model leaves neither.
[[nodiscard]] ResidualTests test_residual(const model::Record& record, const model::Simulation& simulation);

}  // namespace fantail::identify::result
