// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "logs/roll_log.hpp"
#include "tunnel/tunnel_log.hpp"

namespace fantail::tunnel {

// Where the wind speed of a run comes from. On board it is not known: the rocket hangs still.

/// The tunnel's log that belongs to a roll log: the one named, else the tunnel.csv beside it, else the roll log's own
/// speeds (then without set points of the fan). `truth`: the true speeds of a simulated run come before the tunnel.csv.
/// Throws text::Error (bad_data) when nobody knows the speed.
[[nodiscard]] TunnelLog wind_of(const logs::RollLog& roll, const std::filesystem::path& roll_path,
                                const std::string& named, bool truth);

struct SpeedChoice {
  std::optional<double> speed_m_s{};  ///< by hand
  std::string wind{};                 ///< the tunnel's log by name
  bool truth = false;
};

struct StepSpeed {
  std::optional<double> speed_m_s{};  ///< empty: each row of the log has its own
  std::string source{};
};

/// By hand, or the mean of the tunnel's log while the steps lasted, or the log's own. Throws text::Error (bad_data)
/// as mean_wind_speed_m_s() and wind_of().
[[nodiscard]] StepSpeed speed_of_steps(const logs::RollLog& roll, const std::filesystem::path& roll_path,
                                       const SpeedChoice& choice);

}  // namespace fantail::tunnel
