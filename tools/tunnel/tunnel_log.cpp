// SPDX-License-Identifier: MIT
#include "tunnel/tunnel_log.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "files/load.hpp"
#include "files/rows.hpp"
#include "flight/table.hpp"
#include "text/error.hpp"

namespace fantail::tunnel {
namespace {

using text::Error;
using text::ErrorKind;

}  // namespace

TunnelLog read_tunnel_log(const std::filesystem::path& path, const files::Sources& columns) {
  std::error_code ignored;
  std::filesystem::path file = path;
  if (std::filesystem::is_directory(path, ignored)) {
    file /= "tunnel.csv";
    if (!std::filesystem::exists(file, ignored)) {
      throw Error{ErrorKind::no_such_input, path.string() + ": this folder contains no tunnel.csv"};
    }
  }
  const flight::Table table = files::load(file, files::Beside::ftl).table;
  std::vector<files::Found> found;
  for (const files::Quantity quantity : tunnel_quantities) {
    found.push_back(files::find_column(table, columns, quantity, ""));
    found.back().needed = true;
  }
  found[1].least = 0.0;
  files::Rows rows = files::read_rows(table, found, {});
  TunnelLog log{.name = path.string(),
                .time_s = std::move(rows.values[0]),
                .fan_rpm = std::move(rows.values[1]),
                .wind_speed_m_s = std::move(rows.values[2]),
                .remarks = std::move(rows.notes)};
  if (log.time_s.size() < 2) {
    text::refuse(file.string() + ": fewer than two rows with numbers");
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
    text::refuse(
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
