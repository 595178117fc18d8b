// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "telemetry/receiver.hpp"

namespace fantail::telemetry {

/// "launched -> controlling (guide_clear)", "canard 3: healthy -> stalled".
[[nodiscard]] std::string words(const Event& event);

}  // namespace fantail::telemetry
