// SPDX-License-Identifier: MIT
#include "logs/turns.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fantail::logs {

std::size_t continue_over_turns(RollLog& log) {
  constexpr double turn = 2.0 * std::numbers::pi;
  std::vector<double>& angle = log.roll_angle_rad;
  const std::vector<double>& rate = log.roll_rate_rad_s;
  if (angle.empty() || rate.empty() || std::ranges::any_of(angle, [](double a) { return std::isnan(a); })) {
    return 0;
  }
  const auto [low, high] = std::ranges::minmax_element(angle);
  if (*high - *low > 1.01 * turn) {  // an angle that goes on already
    return 0;
  }
  std::size_t jumps = 0;
  double added = 0.0;
  double before = angle[0];
  for (std::size_t i = 1; i < angle.size(); ++i) {
    const double expected = 0.5 * (rate[i - 1] + rate[i]) * (log.time_s[i] - log.time_s[i - 1]);
    const double surprise = angle[i] - before - expected;
    before = angle[i];
    // Behind a long gap the rate is no witness any more, and the model starts anew there.
    if (std::abs(expected) < 0.5 && std::abs(std::abs(surprise) - turn) < 1.0) {
      added -= std::copysign(turn, surprise);
      ++jumps;
    }
    angle[i] += added;
  }
  return jumps;
}

}  // namespace fantail::logs
