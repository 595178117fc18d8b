// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fantail::page {

/// Which samples of several series on one clock to draw: of each of `buckets` equal stretches the first sample and the
/// smallest and largest of every series, and the last sample of all. No peak is lost, however short; NaN is skipped.
/// Increasing indices without repeats. All series have the same length.
[[nodiscard]] std::vector<std::size_t> keep_extremes(std::span<const std::vector<double>> series, std::size_t buckets);

/// The samples before which others are missing: each comes five times later than is usual here. Increasing.
[[nodiscard]] std::vector<std::size_t> gaps(std::span<const double> x);

}  // namespace fantail::page
