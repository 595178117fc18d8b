// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "predict/decision.hpp"

namespace fantail::predict {

/// Of a launch that is faster in some run than the simulation of roll holds for; empty otherwise. Never met: what is
/// outside the model cannot be judged, whatever the runs look like.
[[nodiscard]] std::optional<Criterion> within_model(const Prediction& prediction);

/// Runs that would be held if the simulation held there.
[[nodiscard]] std::size_t steady_outside_model(const Prediction& prediction);

}  // namespace fantail::predict
