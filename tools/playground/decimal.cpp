// SPDX-License-Identifier: MIT
// text/number.hpp without std::from_chars, which libc++ 19 has for whole numbers only. strtod of musl rounds as
// exactly, and there is no locale; what it reads beyond decimals is taken away from it.
#include <cmath>
#include <cstdlib>
#include <string>

#include "text/number.hpp"

namespace fantail::text {

std::optional<double> decimal(std::string_view text) {
  if (text.empty() || text.starts_with('+') || text.find_first_not_of("0123456789+-.eE") != std::string_view::npos) {
    return std::nullopt;
  }
  const std::string copy{text};
  char* rest = nullptr;
  const double value = std::strtod(copy.c_str(), &rest);
  const bool is_all = rest == copy.c_str() + copy.size();
  return is_all && std::isfinite(value) ? std::optional{value} : std::nullopt;
}

}  // namespace fantail::text
