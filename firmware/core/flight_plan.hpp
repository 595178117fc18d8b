// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/angle.hpp"
#include "core/inputs.hpp"
#include "core/run_plan.hpp"
#include "core/time.hpp"

namespace fantail::core {

// Every number of one run. Units, defaults, allowed ranges and meanings stand once, in flight_plan_table.hpp; a plan
// comes from default_plan() or a loader and must pass validate() before it flies.

/// No canard is ever commanded beyond this, whatever a plan says.
inline constexpr Angle hard_canard_limit = Angle::from_degrees(20.0F);

/// Which gyros are flown on.
enum class GyroRule : std::uint8_t {
  one,        ///< Inputs::gyro alone
  two_agree,  ///< what GyroPair makes of two
};

/// Of a sensor, as its data sheet draws it: along an axis (`plus_x`, `plus_y`, `plus_z`) or against it
/// (`minus_x`, `minus_y`, `minus_z`). The numbers of the two directions of an axis differ in their last bit.
enum class SensorAxis : std::uint8_t { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };

/// How a sensor is soldered into the rocket: which of its axes points to the nose (the rocket's x), and which along the
/// rocket's y. The third follows, because both are right-handed, so that no plan can mirror the roll.
struct SensorMounting {
  SensorAxis to_nose;
  SensorAxis along_y;
};

/// What a barometer is there for.
enum class BarometerUse : std::uint8_t {
  none,   ///< none is fitted, or nobody listens to it
  fused,  ///< height and vertical speed follow it, see BarometricHeight
};

/// How the sensors stand in the rocket, when two gyros agree, and the air that a barometer is read in.
struct SensorsPlan {
  GyroRule gyros;
  float gyro_disagreement_rad_s;  ///< on each axis; a twentieth of the largest rate is added
  SensorMounting imu;
  SensorMounting second_imu;
  SensorMounting accelerometer;  ///< the second one, outside of the IMU
  BarometerUse barometer;
  float air_temperature_c;        ///< at the pad, on the day of the launch ...
  float air_temperature_error_k;  ///< ... and by how much it may be another one
};

/// Which accelerometers must see a launch.
enum class AccelerometerRule : std::uint8_t {
  one,        ///< the first
  two_agree,  ///< each by itself, and while they do not disagree
};

/// What counts as a launch, see LaunchDetector.
struct LaunchDetectionPlan {
  float threshold_m_s2;  ///< axial specific force
  Microseconds hold;     ///< not below the threshold for this long
  AccelerometerRule accelerometers;
  bool single_allowed;      ///< of two accelerometers, fly on the healthy one when the other is lost
  bool low_pass;            ///< ahead of the threshold; the hold is then measured on its output
  float low_pass_hz;        ///< cut-off; for the difference of two it counts without `low_pass`, too
  float disagreement_m_s2;  ///< largest low-passed difference of two accelerometers
};

/// What is kept of the hold before a launch was detected, see MotionEstimator.
enum class HeightOrigin : std::uint8_t {
  replay,          ///< height and speed
  velocity_only,   ///< the speed, as in the published flight
  from_detection,  ///< neither: both begin at zero, and are too small from then on
};

/// Which samples are accepted, and what counts as rest.
struct MotionPlan {
  HeightOrigin height_origin;
  Microseconds stale_time;        ///< a sample older than this is no sample
  Microseconds longest_gyro_gap;  ///< in flight, control waits this long for a gyro that is silent
  float rest_tolerance_m_s2;      ///< at rest: specific force within 1 g of this ...
  float quiet_rate_rad_s;         ///< ... and no component of the angular rate beyond this
  Microseconds rest_time;         ///< at rest for this long before a launch can be detected again
};

/// What a gyro may read at rest, on each axis: the rest of the quiet rate is for noise, and for a rail in the wind. A
/// mean beyond it is a turn, and no zero.
[[nodiscard]] constexpr float largest_gyro_bias_rad_s(const MotionPlan& plan) { return 0.5F * plan.quiet_rate_rad_s; }

/// R' of the law, which the roll rate is compared with; see pd_controller().
enum class RateReference : std::uint8_t {
  zero,           ///< every rate is damped
  paper_literal,  ///< the reference angle itself, its radians taken as rad/s
};

/// Which of the roll angles that look the same the law begins to hold.
enum class ControlEntry : std::uint8_t {
  as_published,  ///< the reference itself: every turn made before control is turned back
  capture,       ///< the one that can be reached soonest, see Capture
};

/// Of pd_controller(), and how it begins.
struct ControllerPlan {
  float proportional_gain;  ///< kp: canard angle per angle of roll error
  float derivative_gain_s;  ///< kd: canard angle per rate of roll error
  RateReference rate_reference;
  Angle canard_limit;  ///< the plan limit
  ControlEntry entry;
};

/// A plan with more is refused: PlanRule::too_many_values.
inline constexpr std::size_t most_schedule_rows = 6;

/// Factors on the gains of the law over speed; without rows they are as they stand.
struct GainSchedulePlan {
  std::uint8_t speeds_count;                         ///< how many are in use; 0: no schedule
  std::array<float, most_schedule_rows> speeds_m_s;  ///< increasing
  std::uint8_t factors_count;                        ///< the same number, or the plan is refused
  std::array<float, most_schedule_rows> factors;     ///< at these speeds, on all gains of the law
};

/// What is done about a fin offset, see OffsetEstimator.
enum class OffsetRejection : std::uint8_t {
  none,      ///< nothing: the loop rests beside its reference
  integral,  ///< IntegralAction; needs a proportional gain
  observer,  ///< DisturbanceObserver; needs a RollModelPlan and the speed
};

/// What makes the law rest at its reference in spite of a fin offset.
struct OffsetPlan {
  OffsetRejection rejection;       ///< none: as published
  float integral_gain_per_s;       ///< ki, of integral action
  float observer_bandwidth_rad_s;  ///< w, of an observer
};

/// The roll model, for an observer and for capture (Eq 1-3). Zero if not given.
struct RollModelPlan {
  float roll_inertia_kg_m2;  ///< I, after burn-out
  float reference_area_m2;   ///< A
  float damping_m2;          ///< alpha
  float torque_m;            ///< beta
  float density_kg_m3;       ///< rho, taken to be the same at every height
};

/// The roll programme, see roll_reference().
enum class ReferenceKind : std::uint8_t {
  hold,         ///< one angle all the time
  steps,        ///< an angle from each of some times on
  square_wave,  ///< two angles in turn (Eq 12)
};

/// A plan with more is refused: PlanRule::too_many_values.
inline constexpr std::size_t most_reference_steps = 8;

/// R over the time after control start. Roll angles are not wrapped: 720 degrees are two turns. What belongs to another
/// kind must be valid all the same, and is not used.
struct ReferencePlan {
  ReferenceKind kind;
  Angle initial;                                              ///< until the first step, or until the square wave begins
  std::uint8_t step_times_count;                              ///< how many are in use
  std::array<Microseconds, most_reference_steps> step_times;  ///< after control start, increasing
  std::uint8_t step_angles_count;                             ///< the same number, or the plan is refused
  std::array<Angle, most_reference_steps> step_angles;        ///< each from its time on, the last one to the end
  Microseconds square_wave_begin;                             ///< of the first half wave, after control start
  Angle square_wave_first;                                    ///< R0, in the first half wave and every other one
  Angle square_wave_second;                                   ///< R1, in those between
  float square_wave_frequency_hz;                             ///< f0, of whole waves
};

/// What shakes the roll for system identification, see Chirp.
enum class ExcitationForm : std::uint8_t {
  none,     ///< zero at all times
  product,  ///< as published: a frequency that is multiplied with the time
  sweep,    ///< a frequency that runs evenly from first to last
};

/// Of Chirp.
struct ExcitationPlan {
  ExcitationForm form;
  Angle amplitude;           ///< A0, of the roll command
  Microseconds begin;        ///< after control start
  Microseconds end;          ///< off from this instant on; later than `begin`, unless the form is none
  float product_slope_hz_s;  ///< product form: sin(2 pi (slope t + offset) t)
  float product_offset_hz;
  float sweep_first_hz;  ///< sweep form: instantaneous frequency at begin and at end
  float sweep_last_hz;
  Angle amplitude_variation;     ///< largest dA, either way; 0: none
  float frequency_variation_hz;  ///< largest df, either way; 0: none
  std::uint32_t variation_seed;  ///< of both: the same one gives the same variation again
};

/// Which way a canard turns the rocket.
enum class Direction : std::uint8_t {
  normal,    ///< a positive shaft angle rolls the rocket positively
  reversed,  ///< a positive shaft angle rolls it negatively
};

/// One canard and its servo. Shaft angles, positive as the encoder counts.
struct CanardPlan {
  Direction direction;
  Angle trim;                 ///< shaft angle at which the canard makes no roll moment
  float pulse_centre_us;      ///< at shaft angle zero
  float pulse_per_radian_us;  ///< negative where a longer pulse turns the shaft negatively; never near zero
  Angle encoder_zero;         ///< what the encoder reads when the shaft stands at zero
  Angle mechanical_stop;      ///< to either side of zero; not within the plan limit
};

/// The four canards, and how fast they first move.
struct CanardsPlan {
  std::array<CanardPlan, canard_count> each;
  float first_motion_rate_rad_s;  ///< at most, from power-up until a canard is where it is commanded
};

/// When a canard does not follow, see CanardMonitor.
struct MonitorPlan {
  Microseconds servo_lag;        ///< first-order lag expected between command and encoder
  Angle tracking_limit;          ///< largest difference between expected and measured angle ...
  Angle disagreement_limit;      ///< ... and between a canard and the middle of the others ...
  Microseconds hold;             ///< ... for this long
  Microseconds encoder_timeout;  ///< an encoder that cannot be read for this long makes its canard dead
};

/// What is recorded besides flights.
struct RecordingPlan {
  float threshold_m_s2;  ///< a specific force beyond this is recorded, whether or not a launch is detected
};

/// Everything that one run is set up with. FlightPlan{} is no plan: its zeros are out of range, and validate() refuses
/// it.
struct FlightPlan {
  RunPlan run;
  SensorsPlan sensors;
  LaunchDetectionPlan launch_detection;
  GuidePlan guide;
  DormancyPlan dormancy;
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
