// SPDX-License-Identifier: MIT
#include "tunnel/session.hpp"

#include <algorithm>
#include <cmath>

#include "text/error.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tunnel {
namespace {

bool has_speed(const logs::RollLog& roll) {
  constexpr double standing_m_s = 0.5;
  return std::ranges::any_of(roll.speed_m_s, [](double speed_m_s) { return speed_m_s > standing_m_s; });
}

std::optional<std::filesystem::path> wind_file(const logs::RollLog& roll, const std::filesystem::path& roll_path,
                                               const std::string& named, bool truth) {
  if (!named.empty()) {
    return named;
  }
  return truth && has_speed(roll) ? std::nullopt : tunnel_log_beside(roll_path);
}

}  // namespace

TunnelLog wind_of(const logs::RollLog& roll, const std::filesystem::path& roll_path, const std::string& named,
                  bool truth) {
  if (const auto file = wind_file(roll, roll_path, named, truth)) {
    return read_tunnel_log(*file, {});
  }
  if (!has_speed(roll)) {
    throw text::Error{text::ErrorKind::bad_data,
                      roll_path.string() +
                          ": no wind speed: there is no tunnel.csv beside it, and the log itself "
                          "has no speed_m_s above 0.5 m/s; name the tunnel's log with --wind..."};
  }
  TunnelLog wind{.name = roll.name};
  for (std::size_t i = 0; i < roll.time_s.size(); ++i) {
    if (std::isfinite(roll.speed_m_s[i])) {
      wind.time_s.push_back(roll.time_s[i]);
      wind.wind_speed_m_s.push_back(roll.speed_m_s[i]);
    }
  }
  return wind;
}

StepSpeed speed_of_steps(const logs::RollLog& roll, const std::filesystem::path& roll_path, const SpeedChoice& choice) {
  if (choice.speed_m_s) {
    return {choice.speed_m_s, "from the command line"};
  }
  if (const auto file = wind_file(roll, roll_path, choice.wind, choice.truth)) {
    return {mean_wind_speed_m_s(read_tunnel_log(*file, {}), find_reference_steps(roll)), "mean of " + file->string()};
  }
  if (!has_speed(roll)) {
    throw text::Error{text::ErrorKind::bad_data,
                      roll_path.string() +
                          ": no wind speed: there is no tunnel.csv beside it, and the log itself "
                          "has no speed_m_s above 0.5 m/s; give --speed or --wind"};
  }
  return {std::nullopt, "of the log"};
}

}  // namespace fantail::tunnel
