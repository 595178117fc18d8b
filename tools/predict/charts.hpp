// SPDX-License-Identifier: MIT
#pragma once

#include "page/chart.hpp"
#include "predict/decision.hpp"

namespace fantail::predict {

// Pictures of predict.html that no table has.

/// The reference of the run that is controlled longest, over the times of the band.
[[nodiscard]] page::Series reference(const Prediction& prediction);
/// How many of the runs have an offset of at most this size, with the canard limit.
[[nodiscard]] page::Chart offset_chart(const Prediction& prediction);
/// Damping and torque of the airframes drawn, and of the tunnel's steps.
[[nodiscard]] page::Chart airframe_chart(const Prediction& prediction);

}  // namespace fantail::predict
