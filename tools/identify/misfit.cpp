// SPDX-License-Identifier: MIT
#include "identify/misfit.hpp"

#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "report/numbers.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

double mean_square(const std::vector<double>& list) {
  double sum = 0.0;
  for (const double value : list) {
    sum += value * value;
  }
  return sum / static_cast<double>(list.size());
}

// Of the residual with itself, 10 ms or a sample later. No mean is taken away: it is a lack of the model, too.
double memory(const Record& record, const std::vector<double>& residual) {
  constexpr double later_s = 0.01;
  constexpr double too_late_s = 0.2;
  double together = 0.0;
  double alone = 0.0;
  std::size_t j = 0;
  for (std::size_t i = 0; i + 1 < record.size(); ++i) {
    while (j + 1 < record.size() && (j <= i || record.time_s[j] - record.time_s[i] < 0.999 * later_s)) {
      ++j;
    }
    if (record.time_s[j] - record.time_s[i] < too_late_s) {
      together += residual[i] * residual[j];
      alone += 0.5 * (residual[i] * residual[i] + residual[j] * residual[j]);
    }
  }
  return alone > 0.0 ? together / alone : 0.0;
}

}  // namespace

std::optional<std::string> misfit(const Record& record, const Identification& result) {
  constexpr double motion = 0.5;
  constexpr double negligible = 0.01;
  std::vector<double> residual = record.roll_rate_rad_s;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    residual[i] -= result.simulation.roll_rate_rad_s[i];
  }
  const double strength = std::sqrt(mean_square(residual));
  if (strength < negligible * std::sqrt(mean_square(record.roll_rate_rad_s)) || memory(record, residual) < motion) {
    return {};
  }
  return fmt::format(
      "The model does not follow this log all the way: what it leaves of the rate, {} deg/s, is motion and not noise. "
      "The "
      "intervals do not cover that. More nodes, another window or {} may help.",
      text::brief(report::degrees(strength), 2), result.loop == Loop::open ? "--fit-lag" : "--servo-lag");
}

}  // namespace fantail::identify
