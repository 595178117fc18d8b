// SPDX-License-Identifier: MIT
#pragma once

#include "page/chart.hpp"
#include "predict/decision.hpp"

namespace fantail::predict {

// The pictures of predict.html.

[[nodiscard]] page::Chart roll_angle_chart(const Prediction& prediction);
[[nodiscard]] page::Chart roll_rate_chart(const Prediction& prediction);
/// How many of the runs have an offset of at most this size, with the canard limit.
[[nodiscard]] page::Chart offset_chart(const Prediction& prediction);
/// Damping and torque of the airframes drawn, and of the tunnel's steps.
[[nodiscard]] page::Chart airframe_chart(const Prediction& prediction);
[[nodiscard]] page::Chart phase_margin_chart(const Prediction& prediction, const Thresholds& thresholds);

}  // namespace fantail::predict
