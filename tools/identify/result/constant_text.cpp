// SPDX-License-Identifier: MIT
#include "identify/result/constant_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "text/number.hpp"

namespace fantail::identify::result {

int decimals_for(double value, int digits) {
  return value == 0.0 || !std::isfinite(value) ? digits - 1
                                               : digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
}

std::string constant_text(double value) {
  return text::brief(value, std::max(2, std::abs(value) < 1.0 ? decimals_for(value, 4) : 0));
}

std::string change_text(double now, double before, std::string_view unit) {
  constexpr double same = 1e-4;
  if (std::abs(now - before) < same * std::abs(before)) {
    return fmt::format("{} {} as before", constant_text(before), unit);
  }
  const int places = std::max(2, decimals_for(now - before, 2));
  return fmt::format("{} {} instead of {}", text::brief(now, places), unit, text::brief(before, places));
}

}  // namespace fantail::identify::result
