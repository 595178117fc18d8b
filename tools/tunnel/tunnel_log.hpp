// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/sources.hpp"
#include "logs/roll_log.hpp"

namespace fantail::tunnel {

/// What the tunnel's own instruments read: the fan's set point and the wind sensor. Lists are equally long.
struct TunnelLog {
  std::string name;
  std::vector<double> time_s{};   ///< strictly increasing
  std::vector<double> fan_rpm{};  ///< empty when nobody wrote it down
  std::vector<double> wind_speed_m_s{};
  std::vector<std::string> remarks{};  ///< on rows that were left out, a sentence each
};

inline constexpr std::array tunnel_quantities{files::Quantity::time, files::Quantity::fan, files::Quantity::wind_speed};

/// `path` is a file with the columns time_s, fan_rpm and wind_speed_m_s, or a folder with a tunnel.csv. `columns` says
/// what the file calls them where it has other names. Throws text::Error: no_such_input; bad_data as files::read_rows()
/// does, and for a missing column, a negative set point, fewer than two rows.
[[nodiscard]] TunnelLog read_tunnel_log(const std::filesystem::path& path, const files::Sources& columns);

/// The tunnel.csv that lies in a flight folder, or beside a CSV file. Empty when there is none.
[[nodiscard]] std::optional<std::filesystem::path> tunnel_log_beside(const std::filesystem::path& log);

/// The tunnel's log that belongs to a roll log: the one named, else the tunnel.csv beside it. Empty: take the roll
/// log's own speeds; `truth` prefers those of a simulated run to the tunnel.csv. Throws text::Error (bad_data), which
/// ends with `advice`, when there is no wind speed at all: on board it is not known, because the rocket hangs still.
[[nodiscard]] std::optional<TunnelLog> find_tunnel_log(const logs::RollLog& roll,
                                                       const std::filesystem::path& roll_path, const std::string& named,
                                                       bool truth, const char* advice);

/// The same; for the roll log's own speeds a log without set points of the fan.
[[nodiscard]] TunnelLog wind_of(const logs::RollLog& roll, const std::filesystem::path& roll_path,
                                const std::string& named, bool truth);

}  // namespace fantail::tunnel
