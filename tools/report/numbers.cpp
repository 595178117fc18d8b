// SPDX-License-Identifier: MIT
#include "report/numbers.hpp"

#include <cmath>

#include <fmt/core.h>

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

std::string with_minus(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(';
    const bool number = i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9';
    result += text[i] == '-' && begins && number ? std::string_view{"\u2212"} : text.substr(i, 1);
  }
  return result;
}

}  // namespace fantail::report
