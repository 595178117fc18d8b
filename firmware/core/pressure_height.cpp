// SPDX-License-Identifier: MIT
#include "core/pressure_height.hpp"

#include <cmath>

namespace fantail::core {

// R L / g is 0.190263: a 8th, a 16th, a 512th, a 2048th and a 4096th are 0.190186.
float pressure_height_m(float ratio, float pad_temperature_k) {
  constexpr float lapse_k_m = 0.0065F;
  float root = ratio;
  float power = 1.0F;
  for (unsigned n = 1; n <= 12; ++n) {
    root = std::sqrt(root);
    if (n == 3 || n == 4 || n == 9 || n == 11 || n == 12) {
      power *= root;
    }
  }
  return pad_temperature_k / lapse_k_m * (1.0F - power);
}

}  // namespace fantail::core
