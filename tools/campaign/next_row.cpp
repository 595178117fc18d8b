// SPDX-License-Identifier: MIT
#include "campaign/next_row.hpp"

#include <algorithm>
#include <cmath>

namespace fantail::campaign {

NextRow::NextRow(const std::vector<Row>& rows, const std::vector<Row>& standard_errors)
    : deviations_{rows}, mean_(rows.front().size(), 0.0) {
  const auto count = static_cast<double>(rows.size());
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    for (const Row& row : rows) {
      mean_[i] += row[i] / count;
    }
    double seen = 0.0;  // variance
    for (Row& deviation : deviations_) {
      deviation[i] -= mean_[i];
      seen += deviation[i] * deviation[i] / (count - 1.0);
    }
    double of_measurement = 0.0;
    for (const Row& error : standard_errors) {
      of_measurement += error[i] * error[i] / count;
    }
    // Variance of one more row: what the rows have beyond measurement, and all that makes their mean uncertain.
    const double between = seen > 0.0 ? std::max(1.0 - of_measurement / seen, 0.0) : 1.0;
    const double scale = std::sqrt((between + 1.0 / count) / (count - 1.0));
    for (Row& deviation : deviations_) {
      deviation[i] *= scale;
    }
  }
}

NextRow::Row NextRow::draw(std::span<const double> normals) const {
  const std::size_t degrees_of_freedom = deviations_.size() - 1;
  double chi_squared = 0.0;
  for (const double normal : normals.first(degrees_of_freedom)) {
    chi_squared += normal * normal;
  }
  // One factor for all numbers: their correlation stays, and each has Student's t distribution.
  const double tail = std::sqrt(static_cast<double>(degrees_of_freedom) / chi_squared);
  // A sum of the deviations, each with a normal factor of its own, has exactly their covariance, also where there are
  // fewer rows than numbers in a row.
  Row drawn = mean_;
  for (std::size_t k = 0; k < deviations_.size(); ++k) {
    const double share = tail * normals[degrees_of_freedom + k];
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      drawn[i] += share * deviations_[k][i];
    }
  }
  return drawn;
}

}  // namespace fantail::campaign
