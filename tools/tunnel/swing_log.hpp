// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fantail::tunnel {

/// The pitch of a pinned rocket over time, evenly sampled as near as its logger could.
struct SwingLog {
  std::string name;              ///< as the person wrote it
  bool is_rate = true;           ///< the pitch rate; else the pitch angle
  std::vector<double> time_s{};  ///< strictly increasing; of a flight record from control start on
  std::vector<double> value{};   ///< rad/s or rad
  /// Of a rate its integral, without the bias that its median shows; of an angle itself. From the first sample on.
  std::vector<double> angle_rad{};
  std::vector<std::string> remarks{};  ///< a sentence each
};

/// `path` is a flight log (.ftl) or a folder with one: the recorded gyro, along the direction across the rocket in
/// which it swings most, its mean taken off. Or a CSV file with time_s and one of pitch_rate_deg_s and pitch_deg.
/// Throws text::Error: no_such_input; bad_data for what is neither, for gaps in time that go backwards, for too few
/// rows.
[[nodiscard]] SwingLog read_swing_log(const std::filesystem::path& path);

/// Means over `bin_s`: noise of neighbours is then independent, and an hour at 1 kHz stays small.
[[nodiscard]] SwingLog averaged(const SwingLog& log, double bin_s);

}  // namespace fantail::tunnel
