// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "detection/rule.hpp"

namespace fantail::detection {

/// Of the models and of what these rules make of them: a digest of a few events of every kind. Another one when a model
/// draws something else, or when the flight law decides otherwise in one of these events.
[[nodiscard]] std::string fingerprint(std::span<const Rule> rules);

}  // namespace fantail::detection
