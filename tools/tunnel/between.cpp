// SPDX-License-Identifier: MIT
#include "tunnel/between.hpp"

#include <algorithm>
#include <cmath>

#include "tunnel/statistics.hpp"

namespace fantail::tunnel {
namespace {

// The regularised incomplete gamma function of half the value, by its series (Abramowitz and Stegun 6.5.29).
double chi_square_probability(double value, double degrees_of_freedom) {
  const double a = 0.5 * degrees_of_freedom;
  const double x = 0.5 * value;
  double term = std::exp(a * std::log(x) - x - std::lgamma(a + 1.0));
  double sum = term;
  for (int k = 1; term > 1e-16 * sum || k < x; ++k) {
    term *= x / (a + k);
    sum += term;
  }
  return sum;
}

double root_of_rest(double variance, double taken_off) { return std::sqrt(std::max(variance - taken_off, 0.0)); }

}  // namespace

double chi_square_quantile(double probability, double degrees_of_freedom) {
  double low = 0.0;
  double high = degrees_of_freedom + 1.0;
  while (chi_square_probability(high, degrees_of_freedom) < probability) {
    low = high;
    high *= 2.0;
  }
  constexpr int halvings = 200;
  for (int i = 0; i < halvings && high - low > 1e-10 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (chi_square_probability(middle, degrees_of_freedom) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

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
  return {.seen = seen,
          .measurement = std::sqrt(of_measurement),
          .between = root_of_rest(seen * seen, of_measurement),
          .low = root_of_rest(freedom * seen * seen / chi_square_quantile(0.975, freedom), of_measurement),
          .high = root_of_rest(freedom * at_least_expected / chi_square_quantile(0.025, freedom), of_measurement)};
}

}  // namespace fantail::tunnel
