// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "predict/prediction.hpp"

namespace fantail::predict {

/// Where a wind tilts the rocket until the plan's tilt limit ends control early: in how much less of it the first runs,
/// flown again, do not come to that; or that they do even without wind. Empty where no run does.
[[nodiscard]] std::string advice_on_wind(const Prediction& prediction);

}  // namespace fantail::predict
