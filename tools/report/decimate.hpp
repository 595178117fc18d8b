// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fantail::report {

/// Which samples of several series on one clock to draw: of each of `buckets` equal stretches the first sample and the
/// smallest and largest of every series, and the last sample of all. No peak is lost, however short; NaN is skipped.
/// Increasing indices without repeats. All series have the same length.
[[nodiscard]] std::vector<std::size_t> keep_extremes(std::span<const std::vector<double>> series, std::size_t buckets);

}  // namespace fantail::report
