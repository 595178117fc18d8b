// SPDX-License-Identifier: MIT
#include "stability/round_numbers.hpp"

#include <array>
#include <cmath>

namespace fantail::stability {

std::vector<double> round_numbers_between(double from, double to) {
  constexpr std::array numbers{1.0, 1.1, 1.2, 1.3, 1.5, 1.6, 1.8, 2.0, 2.2, 2.4, 2.7, 3.0,
                               3.3, 3.6, 3.9, 4.3, 4.7, 5.1, 5.6, 6.2, 6.8, 7.5, 8.2, 9.1};
  std::vector<double> all;
  // Through whole exponents and a division: 0.43 is then the number that a person types.
  for (int exponent = static_cast<int>(std::floor(std::log10(from))); std::pow(10.0, exponent) <= to; ++exponent) {
    for (const double number : numbers) {
      const double value = exponent < 0 ? number / std::pow(10.0, -exponent) : number * std::pow(10.0, exponent);
      if (value >= from && value <= to) {
        all.push_back(value);
      }
    }
  }
  return all;
}

}  // namespace fantail::stability
