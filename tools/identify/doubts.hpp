// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "identify/model/roll_model.hpp"
#include "identify/result/findings.hpp"

namespace fantail::identify {

/// Sentences on what is likely wrong with a log or a model although the fit has converged, each with what to change:
/// the unit of the canard column; a lag of it, missing nodes, where another model with just that fits significantly
/// better and gives another alpha or beta (these in the open loop, and only where beta is known to be positive);
/// residuals that neither explains.
[[nodiscard]] std::vector<std::string> doubts(const model::Record& record, const model::Airframe& airframe,
                                              model::Start start, const result::Identification& found);

}  // namespace fantail::identify
