// SPDX-License-Identifier: MIT
#pragma once

/// Values below which a random number of a distribution lies with a probability, which is above 0 and below 1. To nine
/// digits or more, where nothing else is said.
namespace fantail::distributions {

/// Mean 0 and variance 1; exact to a few units in the last place of 1.
[[nodiscard]] double normal_quantile(double probability);
/// The other way: how probable it is that such a number is larger than this. Exact far out, too.
[[nodiscard]] double normal_tail(double number);
/// normal_quantile(0.975): 95 % lie between it and its negative.
inline constexpr double normal_975 = 1.959963984540054;

/// A sum of as many squared normal numbers as there are degrees of freedom, more than 0.
[[nodiscard]] double chi_square_quantile(double probability, double degrees_of_freedom);

/// Between 0 and 1, with the density x^(a - 1) (1 - x)^(b - 1); a and b are above 0.
[[nodiscard]] double beta_quantile(double probability, double a, double b);

/// Student's, for 95 % between it and its negative. To six digits; fewer than 1 degree of freedom count as 1.
[[nodiscard]] double student_975(double degrees_of_freedom);

}  // namespace fantail::distributions
