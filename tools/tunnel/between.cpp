// SPDX-License-Identifier: MIT
#include "tunnel/between.hpp"

#include <algorithm>
#include <cmath>

#include "distributions/quantiles.hpp"
#include "tunnel/statistics.hpp"

namespace fantail::tunnel {
namespace {

double root_of_rest(double variance, double taken_off) { return std::sqrt(std::max(variance - taken_off, 0.0)); }

}  // namespace

Between between_values(std::span<const double> values, std::span<const double> standard_errors) {
  double of_measurement = 0.0;
  for (const double error : standard_errors) {
    of_measurement += error * error / static_cast<double>(standard_errors.size());
  }
  const double seen = moments(values).standard_deviation;
  const double freedom = static_cast<double>(values.size()) - 1.0;
  // Values that scatter by less than their errors agree by chance. They bound no further than values that scatter as
  // expected: else a lucky run, or errors that are stated too large, would prove that nothing varies.
  const double at_least_expected = std::max(seen * seen, of_measurement);
  return {
      .seen = seen,
      .measurement = std::sqrt(of_measurement),
      .between = root_of_rest(seen * seen, of_measurement),
      .low = root_of_rest(freedom * seen * seen / distributions::chi_square_quantile(0.975, freedom), of_measurement),
      .high = root_of_rest(freedom * at_least_expected / distributions::chi_square_quantile(0.025, freedom),
                           of_measurement)};
}

}  // namespace fantail::tunnel
