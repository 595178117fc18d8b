// SPDX-License-Identifier: MIT
#include "brief/brief.hpp"

namespace fantail::brief {

std::string motor_class(double impulse_n_s) {
  constexpr double largest_a_n_s = 2.5;
  if (impulse_n_s <= 0.5 * largest_a_n_s) {
    return "below A";
  }
  double largest_n_s = largest_a_n_s;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (impulse_n_s <= largest_n_s) {
      return std::string{letter};
    }
    largest_n_s *= 2.0;
  }
  return "beyond Z";
}

}  // namespace fantail::brief
