// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "predict/decision.hpp"
#include "predict/prediction.hpp"

// A simulated rocket keeps to the line of its guide, a real one bends over and comes to the plan's tilt limit, which
// ends control. A point mass tells when.
namespace fantail::predict {

/// Whether control would last as long as in the runs, or to within a second of the point mass's apogee. Empty for
/// a guide that hardly leans, and without a run under control.
[[nodiscard]] std::optional<Criterion> tilt_limit(const Prediction& prediction);

/// The most that the guide may lean for it, in half degrees, as a sentence; empty where that would be hardly at all.
[[nodiscard]] std::string advice_on_tilt(const Prediction& prediction);

}  // namespace fantail::predict
