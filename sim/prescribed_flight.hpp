// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "sim/ascent.hpp"
#include "sim/monotone_curve.hpp"
#include "sim/rotation.hpp"

namespace fantail::sim {

/// One instant of a path that somebody else has flown. The path lies in the vertical plane in which the rocket leans.
struct PathSample {
  double time_s;          ///< after ignition
  double height_m;        ///< above the foot of the guide
  double up_m_s;          ///< over ground, as the next
  double across_m_s;      ///< to the side that the rocket leans to
  double along_axis_m_s;  ///< through the air
  double density_kg_m3;
  double tilt_rad;  ///< of the axis, from the vertical
  std::optional<double>
      axial_specific_force_m_s2{};  ///< empty: what follows from the speeds; in all samples or in none
};

/// A whole path. It begins at rest.
struct PrescribedPath {
  std::vector<PathSample> samples{};  ///< times strictly increasing, at least two
  double liftoff_s = 0.0;             ///< after ignition, as the next
  std::optional<double> burnout_s{};
  std::optional<double> apogee_s{};  ///< empty: the path ends before
};

/// A rocket that moves as a path says, whatever it weighs and its motor does; only its roll is its own. Between two
/// samples every quantity follows a MonotoneCurve. The felt specific force is the change of the velocity less gravity,
/// so that who integrates it comes to the speeds of the path.
///
/// Example: a rocket that leans by 30 deg and goes along its axis with a speed that grows by 50 m/s2 feels
/// 50 + 9.81 cos(30 deg) = 58.5 m/s2 along its axis.
class PrescribedFlight {
 public:
  explicit PrescribedFlight(const PrescribedPath& path);

  /// To an instant given in seconds after ignition; negative before it. Times increase.
  void advance_to(double time_s);

  [[nodiscard]] double height_m() const { return height_m_; }
  [[nodiscard]] double speed_m_s() const { return speed_m_s_; }  ///< through the air, along the axis
  [[nodiscard]] double density_kg_m3() const { return density_kg_m3_; }
  [[nodiscard]] double tilt_rad() const { return tilt_rad_; }
  [[nodiscard]] double across_m() const { return across_m_; }  ///< from where it stood
  [[nodiscard]] double up_m_s() const { return up_m_s_; }
  [[nodiscard]] double across_m_s() const { return across_m_s_; }
  [[nodiscard]] const AscentEvents& events() const { return events_; }
  [[nodiscard]] bool is_on_ground() const { return !events_.liftoff_s; }
  [[nodiscard]] bool is_over() const { return is_over_; }  ///< the path has no more samples

  /// As of RigidFlight: in the frame of the rocket that does not roll.
  [[nodiscard]] const Vector3& specific_force_m_s2() const { return specific_force_m_s2_; }
  [[nodiscard]] const Vector3& rate_rad_s() const { return rate_rad_s_; }
  [[nodiscard]] const Vector3& angular_acceleration_rad_s2() const { return angular_acceleration_rad_s2_; }

 private:
  void look(double time_s);

  double liftoff_s_;
  std::optional<double> burnout_s_;
  std::optional<double> apogee_s_;
  MonotoneCurve height_;
  MonotoneCurve up_;
  MonotoneCurve across_;
  MonotoneCurve way_across_;
  MonotoneCurve along_axis_;
  MonotoneCurve density_;
  MonotoneCurve tilt_;
  std::optional<MonotoneCurve> axial_;

  double height_m_ = 0.0;
  double speed_m_s_ = 0.0;
  double density_kg_m3_ = 0.0;
  double tilt_rad_ = 0.0;
  double across_m_ = 0.0;
  double up_m_s_ = 0.0;
  double across_m_s_ = 0.0;
  Vector3 specific_force_m_s2_;
  Vector3 rate_rad_s_;
  Vector3 angular_acceleration_rad_s2_;
  AscentEvents events_;
  bool is_over_ = false;
};

}  // namespace fantail::sim
