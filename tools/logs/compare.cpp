// SPDX-License-Identifier: MIT
#include "logs/compare.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "logs/interpolator.hpp"
#include "logs/shift.hpp"
#include "text/error.hpp"

namespace fantail::logs {
namespace {

using text::Error;
using text::ErrorKind;

struct Extent {
  std::size_t begin;
  std::size_t end;
};

Extent samples_between(const RollLog& a, const CompareOptions& options) {
  const double from = options.from_s.value_or(a.time_s.front());
  const double to = options.to_s.value_or(a.time_s.back());
  if (options.from_s && options.to_s && from > to) {
    throw Error{ErrorKind::bad_configuration,
                fmt::format("window: begins at {:g} s, behind its end at {:g} s", from, to)};
  }
  const auto begin = std::ranges::lower_bound(a.time_s, from);
  const auto end = std::ranges::upper_bound(a.time_s, to);
  if (begin >= end) {
    throw Error{ErrorKind::bad_data,
                fmt::format("{}: window {:g} s to {:g} s: there is no sample in it; the data go from {:g} s to {:g} s",
                            a.name, from, to, a.time_s.front(), a.time_s.back())};
  }
  return {static_cast<std::size_t>(begin - a.time_s.begin()), static_cast<std::size_t>(end - a.time_s.begin())};
}

Difference figures(const std::vector<double>& time_s, const std::vector<double>& difference) {
  Difference result{.max_at_s = time_s.front()};
  for (std::size_t i = 0; i < difference.size(); ++i) {
    const double size = std::abs(difference[i]);
    result.mean_abs += size;
    result.rms += size * size;
    if (size > result.max_abs) {
      result.max_abs = size;
      result.max_at_s = time_s[i];
    }
  }
  const auto count = static_cast<double>(difference.size());
  result.mean_abs /= count;
  result.rms = std::sqrt(result.rms / count);
  return result;
}

double choose_shift(const RollLog& a, const RollLog& b, const CompareOptions& options, Extent extent,
                    std::vector<std::string>& warnings) {
  if (!options.find_shift) {
    return options.shift_s;
  }
  const auto found = find_shift(a, b, {extent.begin, extent.end, options.most_shift_s, options.longest_gap_s});
  if (!found) {
    throw Error{ErrorKind::bad_data,
                fmt::format("{} and {}: no shift within {:g} s can be told from another: the logs do not overlap, "
                            "or the roll rates do not change",
                            a.name, b.name, options.most_shift_s)};
  }
  if (found->at_the_edge) {
    warnings.push_back(
        fmt::format("The best shift, {:.3f} s, lies at the edge of what was searched: the logs may be "
                    "farther apart, or show different motions.",
                    found->shift_s));
  }
  return found->shift_s;
}

}  // namespace

Comparison compare(const RollLog& a, const RollLog& b, const CompareOptions& options) {
  const Extent extent = samples_between(a, options);
  Comparison result;
  result.shift_s = choose_shift(a, b, options, extent, result.warnings);
  Interpolator interpolator{b.time_s, options.longest_gap_s};
  for (std::size_t i = extent.begin; i < extent.end; ++i) {
    if (const auto place = interpolator.at(a.time_s[i] + result.shift_s)) {
      result.time_s.push_back(a.time_s[i]);
      result.a_angle_rad.push_back(a.roll_angle_rad[i]);
      result.b_angle_rad.push_back(place->of(b.roll_angle_rad));
      result.a_rate_rad_s.push_back(a.roll_rate_rad_s[i]);
      result.b_rate_rad_s.push_back(place->of(b.roll_rate_rad_s));
    }
  }
  if (result.time_s.empty()) {
    throw Error{ErrorKind::bad_data,
                fmt::format("{} and {}: no overlap: of A's {:g} s to {:g} s nothing lies inside B's {:g} s to {:g} s, "
                            "shifted by {:g} s, where B has no gap above {:g} s",
                            a.name, b.name, a.time_s[extent.begin], a.time_s[extent.end - 1], b.time_s.front(),
                            b.time_s.back(), result.shift_s, options.longest_gap_s)};
  }
  if (const std::size_t lost = extent.end - extent.begin - result.time_s.size(); lost > 0) {
    result.warnings.push_back(
        fmt::format("{} of A's {} samples in the window have no counterpart in B and are left out.", lost,
                    extent.end - extent.begin));
  }
  if (options.remove_offset) {
    result.offset_rad = result.a_angle_rad.front() - result.b_angle_rad.front();
  }
  for (std::size_t i = 0; i < result.time_s.size(); ++i) {
    result.b_angle_rad[i] += result.offset_rad;
    result.angle_difference_rad.push_back(result.a_angle_rad[i] - result.b_angle_rad[i]);
    result.rate_difference_rad_s.push_back(result.a_rate_rad_s[i] - result.b_rate_rad_s[i]);
  }
  result.angle = figures(result.time_s, result.angle_difference_rad);
  result.rate = figures(result.time_s, result.rate_difference_rad_s);
  return result;
}

}  // namespace fantail::logs
