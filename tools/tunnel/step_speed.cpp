// SPDX-License-Identifier: MIT
#include <algorithm>
#include <span>

#include <fmt/core.h>

#include "text/error.hpp"
#include "tunnel/statistics.hpp"
#include "tunnel/steady.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tunnel {

double mean_wind_speed_m_s(const TunnelLog& wind, const std::vector<ReferenceStep>& steps) {
  const double begin_s = steps.front().begin_s;
  const double end_s = steps.back().end_s;
  const auto index = [&wind](double time_s) {
    return static_cast<std::size_t>(std::ranges::lower_bound(wind.time_s, time_s) - wind.time_s.begin());
  };
  const std::size_t first = index(begin_s);
  const std::size_t count = index(end_s) - first;
  if (count == 0) {
    throw text::Error{
        text::ErrorKind::bad_data,
        fmt::format("{}: no wind speed between {:g} and {:g} s, the time of the steps", wind.name, begin_s, end_s)};
  }
  const auto [slowest, fastest] = std::ranges::minmax(std::span{wind.fan_rpm}.subspan(first, count));
  if (fastest - slowest > SteadyOptions{}.rpm_tolerance) {
    throw text::Error{
        text::ErrorKind::bad_data,
        fmt::format("{}: the fan changes from {:g} to {:g} rpm during the steps; they need a constant wind speed",
                    wind.name, slowest, fastest)};
  }
  return mean(std::span{wind.wind_speed_m_s}.subspan(first, count));
}

StepSpeed speed_of_steps(const logs::RollLog& roll, const std::filesystem::path& roll_path, const SpeedChoice& choice) {
  if (choice.speed_m_s) {
    return {choice.speed_m_s, "from the command line"};
  }
  if (const auto wind = find_tunnel_log(roll, roll_path, choice.wind, choice.truth, "give --speed or --wind")) {
    return {mean_wind_speed_m_s(*wind, find_reference_steps(roll)), "mean of " + wind->name};
  }
  return {std::nullopt, "of the log"};
}

}  // namespace fantail::tunnel
