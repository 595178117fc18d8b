// SPDX-License-Identifier: MIT
#include "flight/six_decimals.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace fantail::flight {
namespace {

constexpr double millionths = 1e6;
// Below it a double still holds halves.
constexpr double most_millionths = 4e15;

}  // namespace

SixDecimals::SixDecimals(double value) {
  // Written so that not-a-number goes the slow way.
  if (std::abs(value) * millionths < most_millionths) {
    const double product = value * millionths;
    const double lost = std::fma(value, millionths, -product);  // product + lost is exact
    double nearest = std::nearbyint(product);
    const double rest = (product - nearest) + lost;
    if (std::abs(rest) != 0.5) {  // std::to_chars below decides a tie
      nearest += rest > 0.5 ? 1.0 : rest < -0.5 ? -1.0 : 0.0;
      const auto whole = static_cast<std::int64_t>(nearest);
      auto digits = static_cast<std::uint64_t>(whole < 0 ? -whole : whole);
      for (int place = 0; place < 7 || digits > 0; ++place) {
        if (place == 6) {
          text_[--begin_] = '.';
        }
        text_[--begin_] = static_cast<char>('0' + digits % 10);
        digits /= 10;
      }
      if (whole < 0) {
        text_[--begin_] = '-';
      }
      return;
    }
  }
  std::array<char, longest> out{};
  const auto end = std::to_chars(out.data(), out.data() + out.size(), std::abs(value) < 0.5e-6 ? 0.0 : value,
                                 std::chars_format::fixed, 6);
  begin_ = longest - static_cast<std::size_t>(end.ptr - out.data());
  std::copy(out.data(), end.ptr, text_.begin() + static_cast<std::ptrdiff_t>(begin_));
}

std::string_view SixDecimals::brief() const {
  std::string_view all = text();
  if (const std::size_t last = all.find_last_not_of('0');
      last != std::string_view::npos && all.find('.') < all.size()) {
    all = all.substr(0, all[last] == '.' ? last : last + 1);
  }
  return all;
}

}  // namespace fantail::flight
