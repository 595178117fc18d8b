// SPDX-License-Identifier: MIT
#include "tunnel/tunnel_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "flight/table.hpp"
#include "text/error.hpp"

namespace fantail::tunnel {
namespace {

using text::Error;
using text::ErrorKind;

constexpr std::array<std::string_view, 3> column_names{"time_s", "fan_rpm", "wind_speed_m_s"};

std::array<std::size_t, 3> find_columns(const flight::Table& table, const flight::ColumnNames& columns) {
  for (const auto& [ours, theirs] : columns) {
    if (std::ranges::find(column_names, ours) == column_names.end()) {
      throw Error{ErrorKind::bad_configuration,
                  fmt::format("{}={}: a tunnel's log has no column {}; it has time_s, fan_rpm, wind_speed_m_s", ours,
                              theirs, ours)};
    }
  }
  std::array<std::size_t, 3> found{};
  std::ranges::transform(column_names, found.begin(), [&](std::string_view name) {
    const auto mapped = columns.find(std::string{name});
    return table.column(mapped == columns.end() ? name : mapped->second);
  });
  return found;
}

void refuse(const std::string& message) { throw Error{ErrorKind::bad_data, message}; }

}  // namespace

TunnelLog read_tunnel_log(const std::filesystem::path& path, const flight::ColumnNames& columns) {
  std::error_code ignored;
  std::filesystem::path file = path;
  if (std::filesystem::is_directory(path, ignored)) {
    file /= "tunnel.csv";
    if (!std::filesystem::exists(file, ignored)) {
      throw Error{ErrorKind::no_such_input, path.string() + ": this folder holds no tunnel.csv"};
    }
  }
  const flight::Table table = flight::Table::load(file.string());
  const auto [time, fan, wind] = find_columns(table, columns);
  TunnelLog log{.name = path.string()};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto time_s = table.number(row, time);
    const auto fan_rpm = table.number(row, fan);
    const auto wind_speed_m_s = table.number(row, wind);
    if (!time_s || !fan_rpm || !wind_speed_m_s) {
      ++log.rows_left_out;
      continue;
    }
    if (!log.time_s.empty() && *time_s <= log.time_s.back()) {
      refuse(fmt::format("{}: time_s = {:g} after {:g}; time must increase", table.where(row), *time_s,
                         log.time_s.back()));
    }
    if (*fan_rpm < 0.0) {
      refuse(fmt::format("{}: fan_rpm = {:g}; allowed: 0 and more", table.where(row), *fan_rpm));
    }
    log.time_s.push_back(*time_s);
    log.fan_rpm.push_back(*fan_rpm);
    log.wind_speed_m_s.push_back(*wind_speed_m_s);
  }
  if (log.rows_left_out * 100 > table.rows()) {
    refuse(
        fmt::format("{}: {} of {} rows have no number in time_s, fan_rpm or wind_speed_m_s; more than 1 % is too many",
                    file.string(), log.rows_left_out, table.rows()));
  }
  if (log.time_s.size() < 2) {
    refuse(file.string() + ": fewer than two rows with numbers");
  }
  return log;
}

std::optional<std::filesystem::path> tunnel_log_beside(const std::filesystem::path& log) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::is_directory(log, ignored) ? log : log.parent_path();
  const std::filesystem::path file = folder / "tunnel.csv";
  return std::filesystem::is_regular_file(file, ignored) ? std::optional{file} : std::nullopt;
}

std::optional<TunnelLog> find_tunnel_log(const logs::RollLog& roll, const std::filesystem::path& roll_path,
                                         const std::string& named, bool truth, const char* advice) {
  if (!named.empty()) {
    return read_tunnel_log(named, {});
  }
  constexpr double standing_m_s = 0.5;
  const bool own_speed = std::ranges::any_of(roll.speed_m_s, [](double speed_m_s) { return speed_m_s > standing_m_s; });
  if (const auto beside = tunnel_log_beside(roll_path); beside && !(truth && own_speed)) {
    return read_tunnel_log(*beside, {});
  }
  if (!own_speed) {
    refuse(
        fmt::format("{}: no wind speed: there is no tunnel.csv beside it, and the log itself has no speed_m_s above "
                    "0.5 m/s; {}",
                    roll_path.string(), advice));
  }
  return std::nullopt;
}

TunnelLog wind_of(const logs::RollLog& roll, const std::filesystem::path& roll_path, const std::string& named,
                  bool truth) {
  if (auto log =
          find_tunnel_log(roll, roll_path, named, truth, "name the tunnel's log with --wind-without or --wind-with")) {
    return std::move(*log);
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

}  // namespace fantail::tunnel
