// SPDX-License-Identifier: MIT
#include "logs/integrated_angle.hpp"

#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "input/messages.hpp"
#include "logs/interpolator.hpp"

namespace fantail::logs {
namespace {

constexpr const char* angle_column = "roll_angle_deg";

}  // namespace

bool may_have_roll_angle(const flight::Table& table, const flight::Reading& reading) {
  if (reading.columns.contains(angle_column)) {
    return true;
  }
  std::vector<std::string> unclaimed;
  for (const std::string& name : table.columns()) {
    if (std::ranges::none_of(reading.columns, [&](const auto& mapped) { return mapped.second == name; })) {
      unclaimed.push_back(name);
    }
  }
  return input::suggestion(angle_column, unclaimed).has_value();
}

void integrate_roll_rate(RollLog& log, const flight::Reading& reading) {
  const double longest_gap_s = std::max(0.1, 5.0 * usual_interval_s(log.time_s));
  std::size_t gaps = 0;
  log.roll_angle_rad.assign(log.time_s.size(), 0.0);
  for (std::size_t i = 1; i < log.time_s.size(); ++i) {
    const double step_s = log.time_s[i] - log.time_s[i - 1];
    gaps += step_s > longest_gap_s ? 1 : 0;
    log.roll_angle_rad[i] =
        log.roll_angle_rad[i - 1] + 0.5 * (log.roll_rate_rad_s[i - 1] + log.roll_rate_rad_s[i]) * step_s;
  }
  std::string sentence =
      "The log has no roll angle: it is the integral of the roll rate, zero at the first sample, and drifts with the "
      "gyro's offset";
  if (gaps > 0) {
    sentence += fmt::format("; over {} of more than {} s the rate is taken to go straight",
                            gaps == 1 ? "a gap" : fmt::format("{} gaps", gaps), input::about(longest_gap_s));
  }
  if (!reading.options.empty()) {
    sentence += fmt::format(". If a column has it: {}columns roll_angle=COLUMN:UNIT", reading.options);
  }
  log.warnings.push_back(sentence + ".");
}

}  // namespace fantail::logs
