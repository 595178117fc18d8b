// SPDX-License-Identifier: MIT
#include "identify/axis_text.hpp"

#include "text/number.hpp"

namespace fantail::identify {

std::optional<Axis> parse_axis(const std::string& text) {
  constexpr double most_values = 1000.0;
  const std::size_t first_colon = text.find(':');
  const std::size_t second_colon = first_colon == std::string::npos ? first_colon : text.find(':', first_colon + 1);
  if (second_colon == std::string::npos) {
    return {};
  }
  const auto first = text::number(text.substr(0, first_colon));
  const auto last = text::number(text.substr(first_colon + 1, second_colon - first_colon - 1));
  const auto step = text::number(text.substr(second_colon + 1));
  if (!first || !last || !step || *first <= 0.0 || *last < *first || *step <= 0.0 ||
      (*last - *first) / *step > most_values - 1.0) {
    return {};
  }
  return Axis{.first = *first, .last = *last, .step = *step};
}

}  // namespace fantail::identify
