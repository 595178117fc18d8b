// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "predict/decision.hpp"

namespace fantail::predict {

/// Of a launch that is in some run beyond a flight::ModelEnd; empty otherwise. Never met: what is outside the model
/// cannot be judged, whatever the runs look like.
[[nodiscard]] std::optional<Criterion> within_model(const Prediction& prediction);

/// No run is beyond another end than that of the angle of attack, which comes with the wind that a run draws: such runs
/// count as not held, and where enough others are, the launch is a go with a caution.
[[nodiscard]] bool is_outside_by_wind_alone(const Prediction& prediction);

/// Runs that would be held if the simulation held there.
[[nodiscard]] std::size_t steady_outside_model(const Prediction& prediction);

/// A clause on a static margin that is little or unknown; empty: neither.
[[nodiscard]] std::string stability_caution(const Prediction& prediction);

}  // namespace fantail::predict
