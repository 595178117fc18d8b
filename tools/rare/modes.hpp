// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "rare/study.hpp"
#include "rare/task.hpp"

namespace fantail::rare {

/// By what the failed flights fail: of two hundred of them, evenly over their margins, each flown again.
[[nodiscard]] std::vector<Mode> modes_of(const Task& task, const std::vector<Sample>& failing,
                                         const std::function<void()>& look);

/// What the probability would be with heavier tails (Study::with_heavier_tails): of the half space of this probability
/// that lies where the failures are. Empty: they lie in no one direction, or no law is normal.
[[nodiscard]] std::optional<double> heavier_tails(const Task& task, const Estimate& estimate);

}  // namespace fantail::rare
