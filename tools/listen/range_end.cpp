// SPDX-License-Identifier: MIT
#include "listen/range_end.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fantail::listen {
namespace {

// Counts times a scale, printed alike: the same count reads the same to this share. A smoothed log passes its largest
// value slowly, and does not repeat it to so many digits.
constexpr double same_reading = 1e-6;
constexpr std::size_t least_in_a_row = 3;
constexpr std::size_t least_others = 10;
constexpr double telling_share = 0.2;

// How often readings repeat, but for one run in twenty: more than once where a logger is faster than its sensor, or a
// median filter stands between them. Empty where there are too few of them to tell.
std::optional<std::size_t> usual_run(std::vector<std::size_t> runs) {
  if (runs.size() < least_others) {
    return std::nullopt;
  }
  const auto long_one = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() * 19 / 20);
  std::ranges::nth_element(runs, long_one);
  return *long_one;
}

bool same(double a, double b) { return std::abs(a - b) <= same_reading * std::max(std::abs(a), std::abs(b)); }

}  // namespace

bool RangeEnd::holds(double reading) const {
  return std::signbit(reading) == std::signbit(value) && std::abs(reading) >= std::abs(value) * (1.0 - same_reading);
}

std::optional<RangeEnd> range_end(const Signal& signal, Side side) {
  if (!signal.is_there()) {
    return std::nullopt;
  }
  const std::vector<double>& v = signal.value;
  RangeEnd end{.value = side == Side::positive ? *std::ranges::max_element(v) : *std::ranges::min_element(v)};
  if (end.value == 0.0 || std::signbit(end.value) != (side == Side::negative)) {
    return std::nullopt;
  }
  std::size_t most = 0;
  std::vector<std::size_t> others;
  std::vector<std::size_t> telling;
  for (std::size_t first = 0, next = 0; first < v.size(); first = next) {
    const bool at_end = end.holds(v[first]);
    for (next = first + 1; next < v.size() && (at_end ? end.holds(v[next]) : same(v[next], v[first]));) {
      ++next;
    }
    if (at_end) {
      end.first_s = end.samples == 0 ? signal.time_s[first] : end.first_s;
      end.samples += next - first;
      end.longest_s = std::max(end.longest_s, signal.time_s[next - 1] - signal.time_s[first]);
      most = std::max(most, next - first);
      continue;
    }
    others.push_back(next - first);
    if (std::abs(v[first]) > telling_share * std::abs(end.value)) {
      telling.push_back(next - first);
    }
  }
  std::optional<std::size_t> usual = usual_run(telling);
  usual = usual ? usual : usual_run(others);
  return usual && most >= least_in_a_row && most > 3 * *usual ? std::optional{end} : std::nullopt;
}

}  // namespace fantail::listen
