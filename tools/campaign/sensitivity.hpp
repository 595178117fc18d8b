// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace fantail::campaign {

/// A figure and where it lies with 95 % probability.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// How much one unknown quantity matters for a result.
struct Influence {
  /// Standardised regression coefficient: by how many of its standard deviations the result moves with one of the
  /// quantity's, the others held. Its sign says in which sense. Empty where quantities depend on each other so closely
  /// that one cannot change without another.
  std::optional<Estimate> slope{};
  /// Sobol's index of first order: the share of the variance of the result that would go if this quantity were known.
  /// It sees what no straight line shows. From the runs as they are, by groups of runs with alike values; may come out
  /// a little below 0.
  Estimate variance_share{};
};

struct Sensitivity {
  std::vector<Influence> of_quantity{};
  double explained = 0.0;  ///< by the straight lines of all quantities together: R^2, adjusted for their number
};

/// `quantities`: one list a quantity, each as long as `result`, no value the same in all runs; `result` neither. There
/// are at least ten runs, and five times as many as quantities. The same numbers and seed give the same intervals.
[[nodiscard]] Sensitivity sensitivity(const std::vector<std::vector<double>>& quantities,
                                      const std::vector<double>& result, std::uint64_t seed);

}  // namespace fantail::campaign
