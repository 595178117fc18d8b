// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flight/flight.hpp"
#include "report/activity.hpp"
#include "report/beginning.hpp"
#include "report/extent.hpp"
#include "report/hold.hpp"

namespace fantail::report {

/// How far the roll that a camera sees and the roll angle, which is the integral of a body rate, came apart since
/// launch detection: the rocket cones. Of a simulated flight in six degrees of freedom.
struct CameraRoll {
  double largest_rad = 0.0;  ///< of the camera's less the true roll angle, with its sign
  double at_end_rad = 0.0;   ///< likewise, at the end of control

  friend bool operator==(const CameraRoll&, const CameraRoll&) = default;
};

/// Row by row.
class CameraRollWatch {
 public:
  /// Each row, in order. Those from launch detection to the end of control count.
  void add(const flight::Row& row);

  [[nodiscard]] const std::optional<CameraRoll>& found() const { return found_; }

 private:
  double zero_rad_ = 0.0;
  std::optional<CameraRoll> found_{};
};

/// Of a canard from the angle of its shaft: from trim, and positive in the sense that rolls the rocket positively.
[[nodiscard]] double deflection_rad(const core::CanardPlan& canard, double angle_rad);

/// What four canards that do not stand alike do beside rolling the rocket: the sum of their deflections as vectors
/// across the axis, with the canards numbered around the rocket so that 1 lies opposite 3, and 2 opposite 4. An angle
/// of one canard; zero while all four turn alike. Deflections are those of the encoders, from the trims of the plan.
struct SideDeflection {
  double largest_rad = 0.0;
  double mean_rad = 0.0;
  /// The largest moment about the centre of gravity that this makes, in air of 1.225 kg/m3. Empty: the vehicle does not
  /// say where its canards are, or the speed is not known.
  std::optional<double> largest_moment_n_m{};

  friend bool operator==(const SideDeflection&, const SideDeflection&) = default;
};

/// Over the ticks in which all four encoders can be read. Empty without any, and without a plan.
[[nodiscard]] std::optional<SideDeflection> side_deflection(const flight::Flight& flight,
                                                            std::span<const flight::Row> control);

/// The numbers of one flight. Empty: the flight has no such figure (no control, no truth, a tunnel run, ...).
///
/// A proportional-derivative loop comes to rest at R + u_d / kp, not at R, so that is what the hold error is measured
/// against, over the settled part of control: without first_settling_time_s() and step_settling_time_s().
struct Figures {
  static constexpr double still_air_m_s = 0.5;  ///< in a tunnel, air that is slower than this stands still

  std::optional<double> apogee_m;       ///< true height where truth exists, else the estimate; empty, too, where the
                                        ///< rows of apogee are missing
  std::optional<double> max_speed_m_s;  ///< likewise; over ground where the flight has a path
  std::optional<double> control_start_height_m;  ///< likewise
  std::optional<double> control_time_s;          ///< first to last tick under control, without what a gate interrupted
  std::optional<double> saturated_fraction;      ///< of the ticks under control, all of which know it
  std::optional<double> largest_hold_error_rad;  ///< largest |true roll angle - (R + u_d / kp)| over the settled part
  std::optional<double> mean_hold_error_rad;     ///< mean of the same
  std::optional<double> judged_time_s;           ///< how long that was; empty where the next is
  std::optional<double> rest_error_rad;          ///< how far from R the roll rests: RunningRest
  std::optional<double> mean_reference_error_rad;  ///< mean |phi - R| of all time under control
  std::optional<double> largest_disturbance_rad;   ///< u_d of largest magnitude under control, with its sign
  std::optional<double> authority_margin_rad;  ///< how much farther the canards could go, or come back, than u_d needs;
                                               ///< the least under control; negative: they cannot balance it
  std::optional<double> authority_rad;         ///< how far they deflect in the sense that this u_d needs
  std::optional<double> roll_turns;            ///< net turns under control, without those while the gate had closed
  std::optional<double> roll_turns_without_control;  ///< in the same time, with its canards at trim
  /// First tick of the saturation that lasts to the end of control, when that is at least half a second.
  std::optional<double> at_limit_since_s;
  double command_at_end_rad = 0.0;              ///< last command under control
  bool offset_beyond_limit = false;             ///< |u_d| exceeded the limit at the end of that saturation
  std::optional<double> offset_at_limit_rad;    ///< u_d of largest magnitude during it
  std::optional<double> ended_before_apogee_s;  ///< control ended this long before apogee; negative: after it
  std::optional<double> roll_after_end_rad;     ///< largest |roll angle - that at the end of control| until apogee
  std::optional<Oscillation> oscillation;
  std::optional<SideDeflection> side_deflection;
  std::optional<CameraRoll> camera_roll;
  Neutral neutral{};
  Opening opening{};
  Capture capture{};                    ///< at control start
  std::vector<Reopening> reopenings{};  ///< the gate had closed in between
  Extent roll{};                        ///< when the roll angle is known
  HoldRecord hold{};                    ///< when, under control, its distance from the settle point is
  bool begins_under_control = false;    ///< the first row is, so nobody knows since when
  bool misses_control_start = false;    ///< likewise, or a hole lies before the first row under control
  bool in_still_air = false;            ///< in a tunnel whose fan stands, or on a gimbal, at every tick
  core::Phase final_phase = core::Phase::safe;

  friend bool operator==(const Figures&, const Figures&) = default;
};

/// Which speed the rows of this flight have: the true one "through the air", or what stands in a log, "by the log".
[[nodiscard]] std::string_view speed_kind(const flight::Flight& flight);

/// Which speed Figures::max_speed_m_s of this flight is: "top speed over ground".
[[nodiscard]] std::string top_speed_name(const flight::Flight& flight);

[[nodiscard]] Figures figures(const flight::Flight& flight);

/// Of all rows: TrueZero.
[[nodiscard]] double true_zero_rad(const flight::Flight& flight);

}  // namespace fantail::report
