// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "sim/atmosphere.hpp"
#include "sim/drag_over_mach.hpp"
#include "sim/highest_point.hpp"
#include "sim/local_density.hpp"
#include "sim/thrust_curve.hpp"
#include "sim/units.hpp"

namespace fantail::sim {

struct AscentParameters {
  double mass_kg = 0.0;  ///< at ignition, propellant included; above that of the propellant
  double drag_area_m2 = 0.0;
  double guide_tilt_rad = 0.0;  ///< from the vertical, below a right angle
  double guide_length_m = std::numeric_limits<double>::infinity();
  Atmosphere atmosphere{};
  ThrustCurve motor{};
  DragOverMach drag_over_mach{};  ///< factor on the drag area
};

/// Events, in seconds after ignition, each the first instant of advance_to() at which it had happened.
struct AscentEvents {
  std::optional<double> liftoff_s;  ///< net upward acceleration
  std::optional<double> burnout_s;
  std::optional<double> apogee_s;  ///< HighestPoint: it may move until the motor has burnt out
  std::optional<double> landing_s;
};

/// Straight flight along the line of the guide:
///   m dv/dt = F - m g cos(tilt) - 1/2 rho CdA v|v|,   height = distance cos(tilt),
/// mass falling in proportion to impulse. The whole flight stays on that line, also beyond the guide, where a real
/// rocket would bend towards the ground. Before lift-off the pad carries the rocket; after apogee it falls back along
/// the line, tail first, and stays where it started. One that has not left its guide stands on the pad again, as long
/// as its motor has not burnt out.
class Ascent {
 public:
  /// On the pad, before ignition.
  explicit Ascent(const AscentParameters& parameters);

  /// One step (midpoint rule) to an instant given in seconds after ignition; negative before it. Call it every
  /// millisecond with times that increase: on the pad the instants decide when lift-off is seen, in flight they are the
  /// step. Earlier times are ignored in flight.
  void advance_to(double time_s);

  [[nodiscard]] double distance_m() const { return distance_m_; }  ///< along the line of the guide
  [[nodiscard]] double height_m() const { return distance_m_ * cos_tilt_; }
  [[nodiscard]] double speed_m_s() const { return speed_m_s_; }  ///< along the line, positive upwards
  [[nodiscard]] double mass_kg() const { return now_.mass_kg; }
  [[nodiscard]] double density_kg_m3() const { return now_.density_kg_m3; }  ///< of the air at height_m(), to 1e-7
  [[nodiscard]] const AscentEvents& events() const { return events_; }

  /// What an accelerometer along the axis reads: (F - D) / m in flight, g cos(tilt) on the pad and after landing.
  [[nodiscard]] double axial_specific_force_m_s2() const { return now_.specific_force_m_s2; }

  /// What one across the axis reads, away from the ground. A rocket on a straight line does not fall sideways, so
  /// something carries g sin(tilt): the pad and the guide in truth, beyond the guide the model itself. Leaving it out
  /// there would tell whoever integrates specific force and gravity that the rocket leaves the line that it stays on.
  [[nodiscard]] double lateral_specific_force_m_s2() const { return lateral_specific_force_m_s2_; }

 private:
  enum class Stage : std::uint8_t { pad, flight, landed };

  /// All that follows from time, speed and density.
  struct Instant {
    double mass_kg;
    double density_kg_m3;
    double specific_force_m_s2;
  };
  [[nodiscard]] double half_drag_area_m2(double speed_m_s) const;
  [[nodiscard]] Instant in_flight(double time_s, double speed_m_s, double density_kg_m3) const;
  void wait_on_pad(double time_s);
  void fly(double time_s);
  void come_to_rest();

  AscentParameters parameters_;
  double cos_tilt_;
  double gravity_along_m_s2_;
  double lateral_specific_force_m_s2_;
  double half_drag_area_m2_;
  double kg_per_n_s_;
  LocalDensity density_;
  double speed_of_sound_m_s_;  ///< kept up where the drag depends on it
  double time_s_ = 0.0;
  double distance_m_ = 0.0;
  double speed_m_s_ = 0.0;
  bool left_guide_ = false;
  Stage stage_ = Stage::pad;
  Instant now_{};
  AscentEvents events_;
  HighestPoint highest_;
};

}  // namespace fantail::sim
