// SPDX-License-Identifier: MIT
#include <charconv>
#include <memory>
#include <system_error>

#include "text/number.hpp"

namespace fantail::text {

std::optional<double> decimal(std::string_view text) {
  double value = 0.0;
  const char* const begin = std::to_address(text.begin());
  const char* const end = begin + text.size();
  const auto [rest, error] = std::from_chars(begin, end, value);
  return error == std::errc{} && rest == end ? std::optional{value} : std::nullopt;
}

}  // namespace fantail::text
