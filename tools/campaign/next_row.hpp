// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fantail::campaign {

/// Fewer lie on a line: their numbers would seem to depend on each other exactly, and Student's t distribution with one
/// degree of freedom has no mean.
inline constexpr std::size_t fewest_rows = 3;

/// One more row of a table whose rows are all of one kind, airframes in a tunnel: Student's t distribution with one
/// degree of freedom less than there are rows, with the correlations that the rows have among themselves. For each
/// number that is the predictive distribution of the next row: a normal law would take the spread of a few rows for the
/// true one. The variance of measurement, as far as standard errors are stated, is taken off: it is no property of what
/// was measured. It stays in the doubt that so few rows leave about their mean.
class NextRow {
 public:
  using Row = std::vector<double>;

  /// Takes `fewest_rows` or more, all as long as the first, and a standard error for each number of each, or none.
  explicit NextRow(const std::vector<Row>& rows, const std::vector<Row>& standard_errors = {});

  /// How many standard normal numbers a draw takes.
  [[nodiscard]] std::size_t normals() const { return 2 * deviations_.size() - 1; }

  /// Takes normals() independent ones.
  [[nodiscard]] Row draw(std::span<const double> normals) const;

 private:
  std::vector<Row> deviations_;  ///< of each row from their mean, so scaled that their squares add up to the variance
  Row mean_;
};

}  // namespace fantail::campaign
