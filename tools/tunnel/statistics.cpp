// SPDX-License-Identifier: MIT
#include "tunnel/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "distributions/quantiles.hpp"

namespace fantail::tunnel {
namespace {

constexpr std::size_t most_blocks = 2000;

std::vector<double> block_means(std::span<const double> values) {
  const std::size_t length = (values.size() + most_blocks - 1) / most_blocks;
  std::vector<double> means;
  for (std::size_t begin = 0; begin + length <= values.size(); begin += length) {
    means.push_back(mean(values.subspan(begin, length)));
  }
  return means;
}

// How many samples one independent sample takes; at least one.
double correlation_length(std::span<const double> values, const Moments& m) {
  const double squares = m.standard_deviation * m.standard_deviation * static_cast<double>(values.size() - 1);
  double length = 1.0;
  for (std::size_t lag = 1; lag < values.size() / 2 && static_cast<double>(lag) < 5.0 * length; ++lag) {
    double product = 0.0;
    for (std::size_t i = lag; i < values.size(); ++i) {
      product += (values[i] - m.mean) * (values[i - lag] - m.mean);
    }
    length += 2.0 * product / squares;
    length = std::max(length, 1.0);
  }
  return length;
}

double root_of_rest(double variance, double taken_off) { return std::sqrt(std::max(variance - taken_off, 0.0)); }

}  // namespace

double mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

Moments moments(std::span<const double> values) {
  Moments m{.mean = mean(values)};
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - m.mean) * (value - m.mean);
  }
  m.standard_deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
  return m;
}

KnownMean known_mean(std::span<const double> samples) {
  const Moments all = moments(samples);
  KnownMean known{.mean = all.mean, .standard_deviation = all.standard_deviation};
  known.independent_samples = static_cast<double>(samples.size());
  const std::vector<double> blocks = block_means(samples);
  const Moments of_blocks = moments(blocks);
  if (of_blocks.standard_deviation <= 0.0) {
    return known;
  }
  const auto count = static_cast<double>(blocks.size());
  const double independent_blocks = count / correlation_length(blocks, of_blocks);
  // The mean takes away one of the independent blocks, not one of all: blocks that resemble each other scatter about
  // their own mean by less than about the true one.
  const double squares_share = (count - 1.0) / count / std::max(independent_blocks - 1.0, 1.0);
  known.standard_error = of_blocks.standard_deviation * std::sqrt(squares_share);
  const double ratio = all.standard_deviation / known.standard_error;
  known.independent_samples = std::clamp(ratio * ratio, 1.0, known.independent_samples);
  return known;
}

Line fit_line(std::span<const double> x, std::span<const double> y) {
  const double mean_x = mean(x);
  const double mean_y = mean(y);
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  Line line;
  line.slope = xy / xx;
  line.offset = mean_y - line.slope * mean_x;
  line.r_squared = yy > 0.0 ? xy * xy / (xx * yy) : 1.0;
  return line;
}

Between between_values(std::span<const double> values, std::span<const double> standard_errors) {
  double of_measurement = 0.0;
  for (const double error : standard_errors) {
    of_measurement += error * error / static_cast<double>(standard_errors.size());
  }
  const double seen = moments(values).standard_deviation;
  const double freedom = static_cast<double>(values.size()) - 1.0;
  // Values that scatter by less than their errors agree by chance. They bound no further than values that scatter as
  // expected: else a lucky run, or errors that are stated too large, would prove that nothing varies.
  const double at_least_expected = std::max(seen * seen, of_measurement);
  return {
      .seen = seen,
      .measurement = std::sqrt(of_measurement),
      .between = root_of_rest(seen * seen, of_measurement),
      .low = root_of_rest(freedom * seen * seen / distributions::chi_square_quantile(0.975, freedom), of_measurement),
      .high = root_of_rest(freedom * at_least_expected / distributions::chi_square_quantile(0.025, freedom),
                           of_measurement)};
}

std::optional<Unsteadiness> unsteadiness(const TunnelLog& wind, const SteadySegments& steady, double begin_s,
                                         double end_s) {
  constexpr std::size_t fewest_readings = 5;
  const auto index_of = [&wind](auto place) { return static_cast<std::size_t>(place - wind.time_s.begin()); };
  std::size_t first = index_of(std::ranges::lower_bound(wind.time_s, begin_s));
  std::size_t count = index_of(std::ranges::upper_bound(wind.time_s, end_s)) - first;
  const auto around = std::ranges::find_if(
      steady.found, [&](const SteadySegment& segment) { return segment.begin_s < end_s && segment.end_s > begin_s; });
  if (around != steady.found.end()) {
    first = around->first;
    count = around->count;
  }
  if (count < fewest_readings) {
    return std::nullopt;
  }
  const Moments speed = moments(std::span{wind.wind_speed_m_s}.subspan(first, count));
  if (speed.mean <= 0.0) {
    return std::nullopt;
  }
  const double rounding_m_s = rounding_deviation(rounding_of(wind.wind_speed_m_s));
  const double variance = speed.standard_deviation * speed.standard_deviation - rounding_m_s * rounding_m_s;
  return Unsteadiness{.share = std::sqrt(std::max(variance, 0.0)) / speed.mean,
                      .rounding_share = rounding_m_s / speed.mean};
}

}  // namespace fantail::tunnel
