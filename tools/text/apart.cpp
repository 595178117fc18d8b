// SPDX-License-Identifier: MIT
#include "text/apart.hpp"

#include "text/number.hpp"

namespace fantail::text {

std::string apart(double value, double limit, int decimals) {
  constexpr int more = 3;
  for (int digits = decimals; digits <= decimals + more; ++digits) {
    if (std::string text = fixed(value, digits); text != fixed(limit, digits)) {
      return text;
    }
  }
  return fixed(value, decimals);  // they are the same
}

}  // namespace fantail::text
