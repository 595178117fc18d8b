// SPDX-License-Identifier: MIT
#include "distributions/quantiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace fantail::distributions {
namespace {

template <std::size_t count>
double polynomial(const std::array<double, count>& coefficients, double x) {
  double sum = 0.0;
  for (const double coefficient : coefficients) {
    sum = sum * x + coefficient;
  }
  return sum;
}

// Acklam's rational approximations (2003), good to 1.15e-9 of the value.
double first_guess(double probability) {
  constexpr std::array middle_above{-3.969683028665376e+01, 2.209460984245205e+02,  -2.759285104469687e+02,
                                    1.383577518672690e+02,  -3.066479806614716e+01, 2.506628277459239e+00};
  constexpr std::array middle_below{-5.447609879822406e+01, 1.615858368580409e+02,  -1.556989798598866e+02,
                                    6.680131188771972e+01,  -1.328068155288572e+01, 1.0};
  constexpr std::array tail_above{-7.784894002430293e-03, -3.223964580411365e-01, -2.400758277161838e+00,
                                  -2.549732539343734e+00, 4.374664141464968e+00,  2.938163982698783e+00};
  constexpr std::array tail_below{7.784695709041462e-03, 3.224671290700398e-01, 2.445134137142996e+00,
                                  3.754408661907416e+00, 1.0};
  constexpr double tail = 0.02425;
  if (probability < tail) {
    const double q = std::sqrt(-2.0 * std::log(probability));
    return polynomial(tail_above, q) / polynomial(tail_below, q);
  }
  if (probability > 1.0 - tail) {
    const double q = std::sqrt(-2.0 * std::log1p(-probability));
    return -polynomial(tail_above, q) / polynomial(tail_below, q);
  }
  const double q = probability - 0.5;
  return q * polynomial(middle_above, q * q) / polynomial(middle_below, q * q);
}

/// The regularised incomplete gamma function of half the value, by its series (Abramowitz and Stegun 6.5.29).
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

/// The continued fraction of the incomplete beta function (Lentz), for x < (a + 1) / (a + b + 2).
double beta_fraction(double a, double b, double x) {
  constexpr double tiny = 1e-300;
  double c = 1.0;
  double d = 1.0 - (a + b) * x / (a + 1.0);
  d = 1.0 / (std::abs(d) < tiny ? tiny : d);
  double result = d;
  for (int m = 1; m <= 10'000; ++m) {
    const double n = m;
    for (const double numerator : {n * (b - n) * x / ((a + 2.0 * n - 1.0) * (a + 2.0 * n)),
                                   -(a + n) * (a + b + n) * x / ((a + 2.0 * n) * (a + 2.0 * n + 1.0))}) {
      d = 1.0 + numerator * d;
      d = 1.0 / (std::abs(d) < tiny ? tiny : d);
      c = 1.0 + numerator / c;
      c = std::abs(c) < tiny ? tiny : c;
      result *= c * d;
    }
    if (std::abs(c * d - 1.0) < 1e-14) {
      break;
    }
  }
  return result;
}

/// Regularised incomplete beta function.
double beta_share(double a, double b, double x) {
  const double front =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
  return x < (a + 1.0) / (a + b + 2.0) ? front * beta_fraction(a, b, x) / a
                                       : 1.0 - front * beta_fraction(b, a, 1.0 - x) / b;
}

/// Where a share that rises from 0 reaches a probability: between `low` and `high` it does.
template <typename Share>
double place_of(double probability, double low, double high, const Share& share) {
  constexpr int halvings = 200;
  for (int i = 0; i < halvings && high - low > 1e-14 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (share(middle) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double normal_quantile(double probability) {
  // One step of Halley's method.
  const double guess = first_guess(probability);
  const double error = normal_tail(-guess) - probability;
  const double step = error * std::sqrt(2.0 * std::numbers::pi) * std::exp(0.5 * guess * guess);
  return guess - step / (1.0 + 0.5 * guess * step);
}

double normal_tail(double number) { return 0.5 * std::erfc(number / std::numbers::sqrt2); }

double chi_square_quantile(double probability, double degrees_of_freedom) {
  const auto share = [&](double value) { return chi_square_probability(value, degrees_of_freedom); };
  double low = 0.0;
  double high = degrees_of_freedom + 1.0;
  while (share(high) < probability) {
    low = high;
    high *= 2.0;
  }
  return place_of(probability, low, high, share);
}

double beta_quantile(double probability, double a, double b) {
  return place_of(probability, 0.0, 1.0, [&](double value) { return beta_share(a, b, value); });
}

double student_975(double degrees_of_freedom) {
  const double n = std::max(degrees_of_freedom, 1.0);
  constexpr double enough_for_the_expansion = 20.0;
  if (n < enough_for_the_expansion) {
    const double x = beta_quantile(0.05, 0.5 * n, 0.5);  // of n / (n + t^2)
    return std::sqrt(n * (1.0 - x) / x);
  }
  // Cornish-Fisher expansion around the normal quantile (Abramowitz and Stegun 26.7.5).
  constexpr double z = normal_975;
  const double z2 = z * z;
  const double g1 = z * (z2 + 1.0) / 4.0;
  const double g2 = z * ((5.0 * z2 + 16.0) * z2 + 3.0) / 96.0;
  const double g3 = z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / 384.0;
  const double g4 = z * ((((79.0 * z2 + 776.0) * z2 + 1482.0) * z2 - 1920.0) * z2 - 945.0) / 92160.0;
  return z + (g1 + (g2 + (g3 + g4 / n) / n) / n) / n;
}

}  // namespace fantail::distributions
