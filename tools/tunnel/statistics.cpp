// SPDX-License-Identifier: MIT
#include "tunnel/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

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

}  // namespace fantail::tunnel
