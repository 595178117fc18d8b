// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
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

/// A number and the standard deviation of its error.
struct Estimate {
  double value = 0.0;
  double deviation = 0.0;
};

/// One free swing: c + exp(-s t) (a cos w t + b sin w t), fitted by least squares.
struct Swing {
  double begin_s = 0.0;  ///< of what was fitted; on the log's clock
  double end_s = 0.0;
  Estimate frequency_rad_s{};          ///< w, of the damped swing
  Estimate decay_per_s{};              ///< s; below zero it grows
  Estimate stiffness_per_s2{};         ///< w^2 + s^2: restoring moment per angle and inertia
  Estimate damping_ratio{};            ///< s over the square root of that
  double largest_rad = 0.0;            ///< the angle at the begin, as the fit has it
  double logarithmic_decrement = 0.0;  ///< of two maxima on the same side
  std::vector<double> time_s{};        ///< of the samples
  std::vector<double> measured{};
  std::vector<double> fitted{};
};

/// From when to when the rocket swung freely.
struct SwingStretch {
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// Where a push ends and the swing is free: the top of a half wave that is at least twice as high as the one before and
/// a fifth of the highest of all; until the next push, or until the swing is lost in the noise.
[[nodiscard]] std::vector<SwingStretch> find_swings(const SwingLog& log);

/// What one swing tells, or why it tells nothing. The deviations count the residuals' memory: neighbours that resemble
/// each other are worth less than their number.
struct SwingResult {
  SwingStretch stretch{};
  std::optional<Swing> swing{};
  bool is_too_large = false;  ///< for air whose force is in proportion to the angle
  bool grows = false;         ///< it gets larger, or leaves where it hung as no push makes it: the rocket is unstable
  std::string reason{};       ///< a clause, where there is no swing
};
[[nodiscard]] SwingResult fit_swing(const SwingLog& log, const SwingStretch& stretch);

}  // namespace fantail::tunnel
