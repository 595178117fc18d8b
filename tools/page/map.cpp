// SPDX-License-Identifier: MIT
#include "page/map.hpp"

#include <algorithm>

namespace fantail::page {

void give_one_scale(Chart& map) {
  constexpr double least_span = 1.0;
  constexpr double half_with_room = 0.55;
  std::optional<Range> x;
  std::optional<Range> y;
  for (const Series& series : map.series) {
    std::ranges::for_each(series.x, [&](double value) { include(x, value); });
    std::ranges::for_each(series.y, [&](double value) { include(y, value); });
  }
  if (!x || !y) {
    return;
  }
  const double reach = half_with_room * std::max({x->high - x->low, y->high - y->low, least_span});
  const auto around = [reach](const Range& range) {
    const double middle = 0.5 * (range.low + range.high);
    return Range{middle - reach, middle + reach};
  };
  map.x_range = around(*x);
  map.y_range = around(*y);
}

}  // namespace fantail::page
