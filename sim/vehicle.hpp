// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/airframe.hpp"
#include "sim/barometer_model.hpp"
#include "sim/canard_aerodynamics.hpp"
#include "sim/canard_tolerances.hpp"
#include "sim/compressibility.hpp"
#include "sim/drag_over_mach.hpp"
#include "sim/felt_motion.hpp"
#include "sim/geometry.hpp"
#include "sim/recovery.hpp"
#include "sim/roll_plant.hpp"
#include "sim/sensor_models.hpp"
#include "sim/servo.hpp"
#include "sim/thrust_curve.hpp"
#include "sim/units.hpp"
#include "sim/vibration.hpp"

namespace fantail::sim {

/// How one canard is really built in; a plan that believes something else rolls the rocket the wrong way.
struct CanardMounting {
  bool reversed = false;          ///< a positive shaft angle rolls the rocket negatively
  double trim_rad = 0.0;          ///< shaft angle at which it makes no roll moment
  double encoder_zero_rad = 0.0;  ///< what the encoder reads at shaft angle zero
};

/// One rocket as it stands on the pad.
struct Vehicle {
  std::string name;
  std::vector<std::string> assumed;   ///< what in this file nobody has measured, a sentence each
  std::vector<std::string> warnings;  ///< what is doubtful in its files, a sentence each
  double mass_kg = 0.0;               ///< at lift-off, propellant included
  double drag_area_m2 = 0.0;
  DragOverMach drag_over_mach{};
  Compressibility compressibility = Compressibility::none;  ///< of roll damping, roll torque and normal force
  RollPlant roll_plant{};
  /// 95 % of what the reference area may truly be, from and to; empty: nothing is said of it. For predictions.
  std::vector<double> reference_area_range_m2;
  ThrustCurve motor;                          ///< of all motors, with the factor
  double thrust_factor = 1.0;                 ///< over the curve of its file
  int motor_count = 1;                        ///< of a cluster: all of one kind, lit at once
  std::optional<Airframe> airframe;           ///< empty: the rocket moves along straight lines only
  std::vector<std::string> airframe_assumed;  ///< of the airframe, a sentence each
  std::optional<Geometry> geometry;           ///< empty: nobody has described it
  std::vector<std::string> geometry_assumed;  ///< of the geometry, a sentence each
  std::optional<Recovery> recovery;           ///< empty: it falls as it flew
  ServoParameters servo{};                    ///< of a typical one
  ServoSpread servo_spread{};
  std::array<CanardMounting, 4> canards{};
  CanardAerodynamics canard_air{};
  InertialParameters imu{};
  bool second_imu_is_fitted = false;
  InertialParameters second_imu{};
  InertialParameters accelerometer{.full_scale_m_s2 = 32.0 * gravity_m_s2};
  BarometerParameters barometer{};
  VibrationParameters vibration{};
  FeltMotionParameters imu_feels{};
  FeltMotionParameters second_imu_feels{};
  FeltMotionParameters accelerometer_feels{};
  EncoderParameters encoder{};
  CanardTolerances canard_tolerances{};  ///< for the bench; nothing in the simulation follows from them
};

}  // namespace fantail::sim
