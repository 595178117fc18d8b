// SPDX-License-Identifier: MIT
#include "report/numbers.hpp"

#include <cmath>

#include <fmt/format.h>

namespace fantail::report {

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) {
    return "not a number";
  }
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) {
    text.erase(0, 1);
  }
  return text;
}

std::string brief(double value, int decimals) {
  std::string text = fixed(value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
      text.pop_back();
    }
  }
  return text;
}

std::string with_minus(std::string number) {
  if (number.starts_with('-')) {
    number.replace(0, 1, "\u2212");
  }
  return number;
}

}  // namespace fantail::report
