// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "predict/decision.hpp"

namespace fantail::predict {

// The pictures of predict.html, each an svg. Empty where there is nothing to draw.

[[nodiscard]] std::string roll_angle_chart(const Prediction& prediction);
[[nodiscard]] std::string roll_rate_chart(const Prediction& prediction);
/// How many of the runs have an offset of at most this size, with the canard limit.
[[nodiscard]] std::string offset_chart(const Prediction& prediction);
/// Damping and torque of the airframes drawn, and of the tunnel's steps.
[[nodiscard]] std::string airframe_chart(const Prediction& prediction);
[[nodiscard]] std::string phase_margin_chart(const Prediction& prediction, const Thresholds& thresholds);

}  // namespace fantail::predict
