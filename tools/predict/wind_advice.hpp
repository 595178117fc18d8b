// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "predict/prediction.hpp"

namespace fantail::predict {

/// In six degrees of freedom, where the plan's tilt limit ends control early: in how much less wind the first of these
/// runs, flown again, do not come to that, or that they do even without, and whether they do from an upright guide.
/// Empty where no run comes to it. `look` is called after each flight.
[[nodiscard]] std::string advice_on_wind(const Prediction& prediction, const Look& look);

}  // namespace fantail::predict
