// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "identify/identification.hpp"
#include "identify/record.hpp"

namespace fantail::identify {

/// A sentence when the model leaves motion, not noise. The fit asks only for the angle, so the rate is a witness of its
/// own: what a gyro adds is gone within 10 ms, what a model lacks (a node, a lag, a canard that hits a wake) is not. No
/// interval covers such a lack. Residuals below a hundredth of the rate itself are not worth a word.
[[nodiscard]] std::optional<std::string> misfit(const Record& record, const Identification& result);

}  // namespace fantail::identify
