// SPDX-License-Identifier: MIT
#include "logs/compare.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "logs/interpolator.hpp"
#include "text/error.hpp"

namespace fantail::logs {
namespace {

using text::Error;
using text::ErrorKind;

// Of A's samples.
struct Extent {
  std::size_t begin;
  std::size_t end;
};

Extent samples_between(const RollLog& a, const CompareOptions& options) {
  const double from = options.from_s.value_or(a.time_s.front());
  const double to = options.to_s.value_or(a.time_s.back());
  if (options.from_s && options.to_s && from > to) {
    throw Error{ErrorKind::bad_configuration,
                fmt::format("window: begins at {:g} s, after its end at {:g} s", from, to)};
  }
  const auto begin = std::ranges::lower_bound(a.time_s, from);
  const auto end = std::ranges::upper_bound(a.time_s, to);
  if (begin >= end) {
    throw Error{ErrorKind::bad_data,
                fmt::format("{}: the window {:g} s to {:g} s contains no samples; the data run from {:g} s to {:g} s",
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

struct ShiftSearch {
  Extent extent;
  double most_shift_s;
  double longest_gap_s;
};

struct FoundShift {
  double shift_s;
  bool at_the_edge;    ///< of the search: the best may lie beyond
  double mean_square;  ///< what is left of the difference of the rates
};

constexpr double coarse_step_s = 0.005;  // a tenth of a turn of a motion of 20 Hz
// From the trough to the points that bend its parabola: farther away noise matters less, but the trough is no parabola
// there.
constexpr double reach_of_trough_s = 0.02;

struct Trial {
  double mean_square = 0.0;
  std::size_t samples = 0;
};

Trial try_shift(const RollLog& a, const RollLog& b, const ShiftSearch& search, double shift_s) {
  Interpolator interpolator{b.time_s, search.longest_gap_s};
  Trial trial;
  for (std::size_t i = search.extent.begin; i < search.extent.end; ++i) {
    if (const auto place = interpolator.at(a.time_s[i] + shift_s)) {
      const double difference = a.roll_rate_rad_s[i] - place->of(b.roll_rate_rad_s);
      trial.mean_square += difference * difference;
      ++trial.samples;
    }
  }
  if (trial.samples > 0) {
    trial.mean_square /= static_cast<double>(trial.samples);
  }
  return trial;
}

// The shift (of CompareOptions) with the smallest rms difference of the roll rates, much finer than the samples. Only
// shifts count that leave at least half as many samples to compare as the best of them do: a short piece of calm
// always agrees. Empty when nothing can be compared, or when all shifts agree equally well.
std::optional<FoundShift> find_shift(const RollLog& a, const RollLog& b, const ShiftSearch& search) {
  // Between two samples of B noise is averaged, and a shift of half an interval looks better than it is. In steps of
  // whole intervals every trial meets B's samples alike, and the trough between them is found by a parabola.
  const double interval_s = usual_interval_s(b.time_s);
  const double step_s = interval_s * std::max(std::round(coarse_step_s / interval_s), 1.0);
  const auto reach = static_cast<std::ptrdiff_t>(search.most_shift_s / step_s + 1e-9);
  std::vector<Trial> trials;
  for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
    trials.push_back(try_shift(a, b, search, static_cast<double>(k) * step_s));
  }
  const std::size_t most = std::ranges::max(trials, {}, &Trial::samples).samples;
  const auto counts = [most](const Trial& trial) { return trial.samples > 0 && 2 * trial.samples >= most; };
  std::optional<std::size_t> best;
  double worst = 0.0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (counts(trials[i])) {
      worst = std::max(worst, trials[i].mean_square);
      if (!best || trials[i].mean_square < trials[*best].mean_square) {
        best = i;
      }
    }
  }
  if (!best || worst - trials[*best].mean_square <= 1e-9 * worst) {
    return std::nullopt;
  }
  const double coarse_s = static_cast<double>(static_cast<std::ptrdiff_t>(*best) - reach) * step_s;
  const auto beside = static_cast<std::size_t>(std::max(std::round(reach_of_trough_s / step_s), 1.0));
  if (*best < beside || *best + beside >= trials.size() || !counts(trials[*best - beside]) ||
      !counts(trials[*best + beside])) {
    return FoundShift{coarse_s, true, trials[*best].mean_square};
  }
  const double left = trials[*best - beside].mean_square;
  const double middle = trials[*best].mean_square;
  const double right = trials[*best + beside].mean_square;
  const double bend = left - 2.0 * middle + right;
  const double half_width_s = 0.5 * static_cast<double>(beside) * step_s;
  return FoundShift{coarse_s + (bend > 0.0 ? half_width_s * (left - right) / bend : 0.0), false, middle};
}

/// About its mean.
double mean_square_of_rate(const RollLog& log, Extent extent) {
  const auto count = static_cast<double>(extent.end - extent.begin);
  double mean = 0.0;
  for (std::size_t i = extent.begin; i < extent.end; ++i) {
    mean += log.roll_rate_rad_s[i] / count;
  }
  double square = 0.0;
  for (std::size_t i = extent.begin; i < extent.end; ++i) {
    square += (log.roll_rate_rad_s[i] - mean) * (log.roll_rate_rad_s[i] - mean) / count;
  }
  return square;
}

/// Between samples that are farther apart than B's may be, and than A's usually are, nothing is known of A either.
double longest_known_step_s(const RollLog& a, const CompareOptions& options) {
  return std::max(options.longest_gap_s, 3.0 * usual_interval_s(a.time_s)) + 1e-9;
}

void note_holes_of_a(const RollLog& a, double longest_step_s, Extent extent, std::vector<std::string>& warnings) {
  std::size_t holes = 0;
  std::string first;
  for (std::size_t i = extent.begin + 1; i < extent.end; ++i) {
    if (a.time_s[i] - a.time_s[i - 1] > longest_step_s && ++holes == 1) {
      first = fmt::format("{} has no samples between {:.3f} s and {:.3f} s", a.name, a.time_s[i - 1], a.time_s[i]);
    }
  }
  if (holes > 0) {
    warnings.push_back(fmt::format("{}{}: nothing is compared there.", first,
                                   holes == 1   ? ""
                                   : holes == 2 ? ", nor in 1 more gap"
                                                : fmt::format(", nor in {} more gaps", holes - 1)));
  }
}

double choose_shift(const RollLog& a, const RollLog& b, const CompareOptions& options, Extent extent,
                    std::vector<std::string>& warnings) {
  if (!options.find_shift) {
    return options.shift_s;
  }
  const auto found = find_shift(a, b, {extent, options.most_shift_s, options.longest_gap_s});
  if (!found) {
    throw Error{ErrorKind::bad_data, fmt::format("{} and {}: no time shift within {:g} s can be determined: the logs "
                                                 "do not overlap, or the roll rates do not change",
                                                 a.name, b.name, options.most_shift_s)};
  }
  if (found->at_the_edge) {
    warnings.push_back(
        fmt::format("The best shift, {:.3f} s, is at the end of the search range: the true shift may be larger, or the "
                    "logs may show different motions.",
                    found->shift_s));
  }
  constexpr double poor = 0.25;  // of the motion itself: half of it in amplitude
  if (const double motion = mean_square_of_rate(a, extent); found->mean_square > poor * motion) {
    warnings.push_back(
        fmt::format("Even at the best shift within {:g} s, {:.3f} s, the roll rates differ by {:.0f} % (rms) of the "
                    "motion in {}. Either the logs show different motions, or the clocks differ by more: then give "
                    "the shift with --shift.",
                    options.most_shift_s, found->shift_s, 100.0 * std::sqrt(found->mean_square / motion), a.name));
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
                fmt::format("{0} and {1}: no overlap. Samples of {0}: {2:g} s to {3:g} s, shifted by {4:g} s. None "
                            "lies between samples of {1} ({5:g} s to {6:g} s) that are at most {7:g} s apart",
                            a.name, b.name, a.time_s[extent.begin], a.time_s[extent.end - 1], result.shift_s,
                            b.time_s.front(), b.time_s.back(), options.longest_gap_s)};
  }
  if (result.time_s.size() == 1) {
    throw Error{ErrorKind::bad_data,
                fmt::format("{} and {}: there is only one sample to compare, at {:g} s of {}, and two are needed",
                            a.name, b.name, result.time_s.front(), a.name)};
  }
  const bool is_window = options.from_s || options.to_s;
  result.asked_s = is_window ? options.to_s.value_or(a.time_s.back()) - options.from_s.value_or(a.time_s.front())
                             : result.time_s.back() - result.time_s.front();
  const double longest_step_s = longest_known_step_s(a, options);
  for (std::size_t i = 1; i < result.time_s.size(); ++i) {
    const double step_s = result.time_s[i] - result.time_s[i - 1];
    result.known_s += step_s > longest_step_s ? 0.0 : step_s;
  }
  note_holes_of_a(a, longest_step_s, extent, result.warnings);
  if (const std::size_t lost = extent.end - extent.begin - result.time_s.size(); lost > 0) {
    result.warnings.push_back(fmt::format("{} of the {} samples{} of {} have no counterpart in {} and are left out.",
                                          lost, extent.end - extent.begin, is_window ? " in the window" : "", a.name,
                                          b.name));
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
