// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "predict/prediction.hpp"

// What would have to change, tried on the runs before it is said.
namespace fantail::predict {

/// Of those that a plan may have and the canards can reach, the smallest canard limit in half degrees that meets the
/// demand of decide() on the share of runs whose offset can be balanced; or that none does, and why.
[[nodiscard]] std::string advice_on_canard_limit(const Prediction& prediction, double share);

/// Of the gains that a plan may have, the pair nearest to the plan's that gives the loop this phase margin in 95 % of
/// the runs at every speed flown; or that none does, and what servo lag would.
[[nodiscard]] std::string advice_on_gains(const Prediction& prediction, double phase_margin_rad);

}  // namespace fantail::predict
