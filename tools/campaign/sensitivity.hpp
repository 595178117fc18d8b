// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace fantail::campaign {

/// A figure and where it lies with 95 % probability.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// How the result goes with the quantities, along straight lines.
struct Sensitivity {
  /// Of each quantity, the standardised regression coefficient: by how many of its standard deviations the result moves
  /// with one of the quantity's, the others held. Its sign says in which sense. All are empty where
  /// quantities depend on each other so closely that one cannot change without another, or where one run alone decides.
  std::vector<std::optional<Estimate>> slopes{};
  double explained = 0.0;  ///< by the straight lines of all quantities together: R^2, adjusted for their number
};

/// `quantities`: one list a quantity, each as long as `result`, no value the same in all runs; `result` neither. There
/// are at least ten runs, and ten times as many as quantities. The intervals are those of the jackknife, so they ask
/// neither for a straight line nor for noise that is the same everywhere.
[[nodiscard]] Sensitivity sensitivity(const std::vector<std::vector<double>>& quantities,
                                      const std::vector<double>& result);

}  // namespace fantail::campaign
