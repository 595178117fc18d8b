// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/angle.hpp"
#include "core/inputs.hpp"
#include "core/time.hpp"

namespace fantail::core {

// Every number of one run. Units, defaults, allowed ranges and meanings stand once, in flight_plan_table.hpp; a plan
// comes from default_plan() or a loader and must pass validate() before it flies.

/// No canard is ever commanded beyond this, whatever a plan says.
inline constexpr Angle hard_canard_limit = Angle::from_degrees(20.0F);

enum class Start : std::uint8_t { launch, tunnel };
/// share: control goes on, and the healthy canards carry what a faulty one does not do.
enum class CanardFaultPolicy : std::uint8_t { continue_control, end_control, share };

struct RunPlan {
  Start start;
  Microseconds control_time;  ///< control ends this long after control start
  Angle tilt_limit;           ///< control ends when the axis has turned this far from the vertical
  CanardFaultPolicy canard_fault;
  std::uint16_t overrun_limit;  ///< control ticks that may fail to come in a flight, and before it is armed
};

enum class GyroRule : std::uint8_t { one, two_agree };
/// Of a sensor, as its data sheet draws it.
enum class SensorAxis : std::uint8_t { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };

/// How a sensor is soldered into the rocket: which of its axes points to the nose (the rocket's x), and which along the
/// rocket's y. The third follows, because both are right-handed, so that no plan can mirror the roll.
struct SensorMounting {
  SensorAxis to_nose;
  SensorAxis along_y;
};

struct SensorsPlan {
  GyroRule gyros;
  float gyro_disagreement_rad_s;
  SensorMounting imu;
  SensorMounting second_imu;
  SensorMounting accelerometer;
};

enum class AccelerometerRule : std::uint8_t { one, two_agree };

struct LaunchDetectionPlan {
  float threshold_m_s2;  ///< axial specific force
  Microseconds hold;
  AccelerometerRule accelerometers;
  bool single_allowed;  ///< of two accelerometers, fly on the healthy one when the other is lost
  bool low_pass;        ///< ahead of the threshold; the hold is then measured on its output
  float low_pass_hz;
  float disagreement_m_s2;  ///< largest low-passed difference of two accelerometers
};

struct GuidePlan {
  float length_m;
  float clearance_m;            ///< control starts this far beyond the end of the guide ...
  float minimum_speed_m_s;      ///< ... and faster than this ...
  Microseconds clearance_time;  ///< ... within this time of launch detection
};

enum class HeightOrigin : std::uint8_t { replay, velocity_only, from_detection };

struct MotionPlan {
  HeightOrigin height_origin;
  Microseconds stale_time;        ///< a sample older than this is no sample
  Microseconds longest_gyro_gap;  ///< in flight, control waits this long for a gyro that is silent
  float rest_tolerance_m_s2;      ///< at rest: specific force within 1 g of this ...
  float quiet_rate_rad_s;         ///< ... and no component of the angular rate beyond this
  Microseconds rest_time;         ///< at rest for this long before a launch can be detected again
};

enum class RateReference : std::uint8_t { zero, paper_literal };

struct ControllerPlan {
  float proportional_gain;
  float derivative_gain_s;
  RateReference rate_reference;
  Angle canard_limit;  ///< the plan limit
};

inline constexpr std::size_t most_schedule_rows = 6;

/// Factors on the gains of the law over speed; without rows they are as they stand.
struct GainSchedulePlan {
  std::uint8_t speeds_count;
  std::array<float, most_schedule_rows> speeds_m_s;  ///< increasing
  std::uint8_t factors_count;
  std::array<float, most_schedule_rows> factors;
};

enum class OffsetRejection : std::uint8_t { none, integral, observer };

/// What makes the law rest at its reference in spite of a fin offset.
struct OffsetPlan {
  OffsetRejection rejection;  ///< none: as published
  float integral_gain_per_s;
  float observer_bandwidth_rad_s;
};

/// How the rocket rolls, for a law that observes (Eq 1-3). Zero where nobody said so.
struct RollModelPlan {
  float roll_inertia_kg_m2;
  float reference_area_m2;
  float damping_m2;  ///< alpha
  float torque_m;    ///< beta
  float density_kg_m3;
};

enum class ReferenceKind : std::uint8_t { hold, steps, square_wave };
inline constexpr std::size_t most_reference_steps = 8;

struct ReferencePlan {
  ReferenceKind kind;
  Angle initial;  ///< until the first step, or until the square wave begins
  std::uint8_t step_times_count;
  std::array<Microseconds, most_reference_steps> step_times;  ///< after control start, increasing
  std::uint8_t step_angles_count;
  std::array<Angle, most_reference_steps> step_angles;
  Microseconds square_wave_begin;
  Angle square_wave_first;
  Angle square_wave_second;
  float square_wave_frequency_hz;
};

enum class ExcitationForm : std::uint8_t { none, product, sweep };

struct ExcitationPlan {
  ExcitationForm form;
  Angle amplitude;
  Microseconds begin;  ///< after control start
  Microseconds end;
  float product_slope_hz_s;  ///< product form: sin(2 pi (slope t + offset) t)
  float product_offset_hz;
  float sweep_first_hz;  ///< sweep form: instantaneous frequency at begin and at end
  float sweep_last_hz;
  Angle amplitude_variation;
  float frequency_variation_hz;
  std::uint32_t variation_seed;
};

enum class Direction : std::uint8_t { normal, reversed };

/// One canard and its servo. Shaft angles, positive as the encoder counts.
struct CanardPlan {
  Direction direction;  ///< normal: a positive shaft angle rolls the rocket positively
  Angle trim;           ///< shaft angle at which the canard makes no roll moment
  float pulse_centre_us;
  float pulse_per_radian_us;
  Angle encoder_zero;  ///< what the encoder reads when the shaft stands at zero
  Angle mechanical_stop;
};

struct CanardsPlan {
  std::array<CanardPlan, canard_count> each;
  float first_motion_rate_rad_s;
};

struct MonitorPlan {
  Microseconds servo_lag;    ///< first-order lag expected between command and encoder
  Angle tracking_limit;      ///< largest difference between expected and measured angle ...
  Angle disagreement_limit;  ///< ... and between a canard and the middle of the others ...
  Microseconds hold;         ///< ... for this long
  Microseconds encoder_timeout;
};

struct RecordingPlan {
  float threshold_m_s2;  ///< a specific force beyond this is recorded, whether or not a launch is detected
};

struct FlightPlan {
  RunPlan run;
  SensorsPlan sensors;
  LaunchDetectionPlan launch_detection;
  GuidePlan guide;
  MotionPlan motion;
  ControllerPlan controller;
  GainSchedulePlan gain_schedule;
  OffsetPlan offset;
  RollModelPlan roll_model;
  ReferencePlan reference;
  ExcitationPlan excitation;
  CanardsPlan canards;
  MonitorPlan monitor;
  RecordingPlan recording;
};

}  // namespace fantail::core
