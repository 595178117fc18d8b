// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/flight_plan_fields.hpp"

// The one table of everything that a flight plan holds, for the compiler. Whoever takes a row of it at run time takes
// names and meanings along, which a board has no use for: flight_plan_members() is the table without them.
namespace fantail::core::plan_table {

/// For the macros of the rows.
using Plan = FlightPlan;
/// Of the values of a choice, in their order.
using Names = std::span<const std::string_view>;

/// Names of Start in files, in the order of its values, as all of these are.
inline constexpr std::array<std::string_view, 2> start_names{"launch", "tunnel"};
/// Names of CanardFaultPolicy.
inline constexpr std::array<std::string_view, 3> fault_policy_names{"continue", "end_control", "share"};
/// Names of TiltOrigin.
inline constexpr std::array<std::string_view, 2> tilt_origin_names{"vertical", "guide"};
/// Names of AbortInput.
inline constexpr std::array<std::string_view, 3> abort_input_names{"none", "open_aborts", "closed_aborts"};
/// Names of DormantUntil.
inline constexpr std::array<std::string_view, 6> dormant_until_names{
    "guide", "burn_out", "max_dynamic_pressure", "height", "burn_out and height", "max_dynamic_pressure and height"};
/// Names of ControlEntry.
inline constexpr std::array<std::string_view, 2> control_entry_names{"as_published", "capture"};
/// Names of GyroRule.
inline constexpr std::array<std::string_view, 2> gyro_rule_names{"one", "two_agree"};
/// Names of BarometerUse.
inline constexpr std::array<std::string_view, 2> barometer_use_names{"none", "fused"};
/// Names of SensorAxis.
inline constexpr std::array<std::string_view, 6> sensor_axis_names{"+x", "-x", "+y", "-y", "+z", "-z"};
/// Names of AccelerometerRule.
inline constexpr std::array<std::string_view, 2> accelerometer_rule_names{"one", "two_agree"};
/// Names of HeightOrigin.
inline constexpr std::array<std::string_view, 3> height_origin_names{"replay", "velocity_only", "from_detection"};
/// Names of RateReference.
inline constexpr std::array<std::string_view, 2> rate_reference_names{"zero", "paper_literal"};
/// Names of OffsetRejection.
inline constexpr std::array<std::string_view, 3> offset_rejection_names{"none", "integral", "observer"};
/// Names of ReferenceKind.
inline constexpr std::array<std::string_view, 3> reference_kind_names{"hold", "steps", "square_wave"};
/// Names of ExcitationForm.
inline constexpr std::array<std::string_view, 3> excitation_names{"none", "product", "sweep"};
/// Names of Direction.
inline constexpr std::array<std::string_view, 2> direction_names{"normal", "reversed"};

/// Where a value stands in a plan, and what it is there: `offset`, `stride` and `slots` as in PlanMember, in bytes.
struct Place {
  std::size_t offset;
  Kept kept;
  std::size_t stride = 0;
  std::size_t slots = 1;
};

/// How a member of type T is kept. A type that no field has does not compile.
template <typename T>
constexpr Kept kept_as() {
  if constexpr (std::is_same_v<T, Microseconds>) {
    return Kept::time;
  } else if constexpr (std::is_same_v<T, bool>) {
    return Kept::flag;
  } else if constexpr (std::is_enum_v<T>) {
    static_assert(sizeof(T) == 1);
    return Kept::choice;
  } else if constexpr (std::is_integral_v<T>) {
    static_assert(std::is_unsigned_v<T> && (sizeof(T) == 2 || sizeof(T) == 4));
    return sizeof(T) == 2 ? Kept::half_word : Kept::word;
  } else {
    static_assert(std::is_same_v<T, float> || std::is_same_v<T, Angle>);
    return Kept::number;
  }
}

/// What a value in this unit is multiplied with to be rad, rad/s, us/rad or m/s2; 1 for every other unit.
constexpr float scale_of(std::string_view unit) {
  if (unit == "deg" || unit == "deg/s") {
    return pi / 180.0F;
  }
  if (unit == "us/deg") {
    return 180.0F / pi;
  }
  return unit == "g" ? standard_gravity_m_s2 : 1.0F;
}

/// From `minimum` to `maximum`, both allowed, in the unit of a file.
struct Range {
  float minimum;
  float maximum;
};

/// What all rows have in common. It is no list yet.
constexpr PlanMember member(Place place, FieldKind kind, float default_value, Range range, float scale = 1.0F) {
  return {.offset = static_cast<std::uint16_t>(place.offset),
          .length_offset = 0,
          .stride = static_cast<std::uint8_t>(place.stride),
          .slots = static_cast<std::uint8_t>(place.slots),
          .kept = place.kept,
          .has_length = false,
          .kind = kind,
          .default_value = default_value,
          .minimum = range.minimum,
          .maximum = range.maximum,
          .scale = scale};
}

/// A row for a float, an Angle or a time: `default_value` and `range` are in `unit`, from which follows the scale.
constexpr PlanField number(Place place, std::string_view section, std::string_view key, std::string_view unit,
                           float default_value, Range range, std::string_view meaning) {
  return {member(place, FieldKind::number, default_value, range, scale_of(unit)), section, key, unit, {}, meaning};
}

/// A row for an enumeration: `names` has its values in order, `default_value` is the index of one.
constexpr PlanField choice(Place place, std::string_view section, std::string_view key, Names names,
                           std::string_view meaning, float default_value = 0.0F) {
  const Range range{0.0F, static_cast<float>(names.size() - 1)};
  return {member(place, FieldKind::choice, default_value, range), section, key, {}, names, meaning};
}

/// A row for a bool, 0 or 1.
constexpr PlanField flag(Place place, std::string_view section, std::string_view key, bool default_value,
                         std::string_view meaning) {
  return {member(place, FieldKind::flag, default_value ? 1.0F : 0.0F, {0.0F, 1.0F}), section, key, {}, {}, meaning};
}

/// A row for whole numbers of 16 or 32 bits; `range` must keep to what a float has exactly.
constexpr PlanField integer(Place place, std::string_view section, std::string_view key, float default_value,
                            Range range, std::string_view meaning) {
  return {member(place, FieldKind::integer, default_value, range), section, key, {}, {}, meaning};
}

/// The same row for a list, whose length is a byte at `length_offset` of a plan.
constexpr PlanField list(std::size_t length_offset, PlanField field) {
  field.has_length = true;
  field.length_offset = static_cast<std::uint16_t>(length_offset);
  return field;
}

// clang-format off: one field a row reads better than one argument a line
// NOLINTBEGIN(bugprone-macro-parentheses): a member's name in parentheses is no longer one
#define MEMBER(name) Place{offsetof(Plan, name), kept_as<decltype(Plan::name)>()}
#define LIST(name) Place{offsetof(Plan, name), kept_as<decltype(Plan::name)::value_type>(), sizeof(decltype(Plan::name)::value_type), std::size(decltype(Plan::name){})}
#define CANARD(name) Place{offsetof(Plan, canards.each) + offsetof(CanardPlan, name), kept_as<decltype(CanardPlan::name)>(), sizeof(CanardPlan), canard_count}
// NOLINTEND(bugprone-macro-parentheses)
/// Every field, in the order of files and of the wire: an index in it names a field (PlanFault).
inline constexpr auto flight_plan_table = std::to_array<PlanField>({
  choice(MEMBER(run.start), "run", "start", start_names, "how control begins: by launch detection, or on command in the tunnel"),
  number(MEMBER(run.control_time), "run", "control_time_s", "s", 30, {0.1F, 600}, "control ends this long after control start"),
  number(MEMBER(run.tilt_limit), "run", "tilt_limit_deg", "deg", 60, {20, 90}, "control ends when the axis is tilted further than this"),
  choice(MEMBER(run.tilt_from), "run", "tilt_from", tilt_origin_names, "what the tilt is measured from: the vertical, or the axis at rest in the launch guide"),
  choice(MEMBER(run.canard_fault), "run", "canard_fault", fault_policy_names, "what a canard that does not follow does to control; share: the others do its part too", 2),
  integer(MEMBER(run.overrun_limit), "run", "overrun_limit", 20, {0, 1000}, "control ticks that may fail to come in a flight, and from power-up to arming"),
  choice(MEMBER(run.abort_input), "run", "abort_input", abort_input_names, "what ends control: no contact, one that opens (a broken wire does too), or one that closes"),

  choice(MEMBER(sensors.gyros), "sensors", "gyros", gyro_rule_names, "one gyro, or two that agree"),
  number(MEMBER(sensors.gyro_disagreement_rad_s), "sensors", "gyro_disagreement_deg_s", "deg/s", 20, {1, 200}, "largest difference of two gyros"),
  choice(MEMBER(sensors.imu.to_nose), "sensors", "imu_to_nose", sensor_axis_names, "which axis of the IMU points to the nose"),
  choice(MEMBER(sensors.imu.along_y), "sensors", "imu_along_y", sensor_axis_names, "and which along the rocket's y; the third follows", 2),
  choice(MEMBER(sensors.second_imu.to_nose), "sensors", "second_imu_to_nose", sensor_axis_names, "which axis of the second IMU points to the nose"),
  choice(MEMBER(sensors.second_imu.along_y), "sensors", "second_imu_along_y", sensor_axis_names, "and which along the rocket's y; the third follows", 2),
  choice(MEMBER(sensors.accelerometer.to_nose), "sensors", "accelerometer_to_nose", sensor_axis_names, "which axis of the second accelerometer points to the nose"),
  choice(MEMBER(sensors.accelerometer.along_y), "sensors", "accelerometer_along_y", sensor_axis_names, "and which along the rocket's y; the third follows", 2),
  choice(MEMBER(sensors.barometer), "sensors", "barometer", barometer_use_names, "no barometer, or one that height and vertical speed follow while the rocket is slow"),
  number(MEMBER(sensors.air_temperature_c), "sensors", "air_temperature_c", "", 15, {-50, 50}, "air at the pad in degrees Celsius, for a barometer's heights"),
  number(MEMBER(sensors.air_temperature_error_k), "sensors", "air_temperature_error_k", "", 30, {0.5F, 60}, "and by so many kelvins it may be another one"),

  number(MEMBER(launch_detection.threshold_m_s2), "launch_detection", "threshold_g", "g", 2.5F, {1.5F, 15}, "axial specific force that counts as thrust"),
  number(MEMBER(launch_detection.hold), "launch_detection", "hold_s", "s", 0.1F, {0.02F, 2}, "the threshold must be exceeded for this long"),
  choice(MEMBER(launch_detection.accelerometers), "launch_detection", "accelerometers", accelerometer_rule_names, "one accelerometer, or two that agree", 1),
  flag(MEMBER(launch_detection.single_allowed), "launch_detection", "single_allowed", false, "of two accelerometers, fly on one when the other is lost"),
  flag(MEMBER(launch_detection.low_pass), "launch_detection", "low_pass", true, "low-pass the axial specific force ahead of the threshold"),
  number(MEMBER(launch_detection.low_pass_hz), "launch_detection", "low_pass_hz", "Hz", 16, {2, 200}, "cut-off of the low-pass"),
  number(MEMBER(launch_detection.disagreement_m_s2), "launch_detection", "disagreement_g", "g", 0.5F, {0.1F, 5}, "largest low-passed difference of two accelerometers"),

  number(MEMBER(guide.length_m), "guide", "length_m", "m", 4, {0, 30}, "length of the launch guide"),
  number(MEMBER(guide.clearance_m), "guide", "clearance_m", "m", 2, {0, 50}, "control starts this far beyond the end of the guide"),
  number(MEMBER(guide.minimum_speed_m_s), "guide", "minimum_speed_m_s", "m/s", 10, {0, 100}, "and faster than this"),
  number(MEMBER(guide.clearance_time), "guide", "clearance_time_s", "s", 1.5F, {0.2F, 5}, "and within this time of launch detection"),

  choice(MEMBER(dormancy.until), "dormancy", "until", dormant_until_names, "canards stay at trim until the guide is clear, or until this too"),
  number(MEMBER(dormancy.height_m), "dormancy", "height_m", "m", 1500, {1, 30000}, "height above the launch site, for a gate by height"),
  number(MEMBER(dormancy.burn_time), "dormancy", "burn_time_s", "s", 0, {0, 120}, "burn time of the motor from first to last thrust, for a gate by burn-out"),
  number(MEMBER(dormancy.burn_clock_factor), "dormancy", "burn_clock_factor", "", 1.1F, {1, 5}, "burn-out is believed this many burn times after first thrust"),
  number(MEMBER(dormancy.scale_error), "dormancy", "scale_error", "", 0.01F, {0, 0.1F}, "accelerometer error for the height: this share of its reading"),
  number(MEMBER(dormancy.bias_error_m_s2), "dormancy", "bias_error_g", "g", 0.06F, {0, 0.5F}, "and this much at any reading"),

  choice(MEMBER(motion.height_origin), "motion", "height_origin", height_origin_names, "where height and speed begin: first thrust replayed, its speed only, or launch detection"),
  number(MEMBER(motion.stale_time), "motion", "stale_time_s", "s", 0.005F, {0.004F, 0.02F}, "a sample older than this counts as missing"),
  number(MEMBER(motion.longest_gyro_gap), "motion", "longest_gyro_gap_s", "s", 0.25F, {0, 1}, "under control, canards wait at trim this long for a silent gyro"),
  number(MEMBER(motion.rest_tolerance_m_s2), "motion", "rest_tolerance_g", "g", 0.1F, {0.02F, 0.3F}, "at rest: specific force within 1 g of this"),
  number(MEMBER(motion.quiet_rate_rad_s), "motion", "quiet_rate_deg_s", "deg/s", 2, {0.5F, 20}, "at rest: no angular rate beyond this"),
  number(MEMBER(motion.rest_time), "motion", "rest_time_s", "s", 2, {0.5F, 10}, "at rest this long, and 3.6 s at least, before a launch can be detected again"),

  number(MEMBER(controller.proportional_gain), "controller", "proportional_gain", "", 0.5F, {0, 10}, "canard angle per roll angle error (kp)"),
  number(MEMBER(controller.derivative_gain_s), "controller", "derivative_gain_s", "s", 0.05F, {0, 2}, "canard angle per roll rate (kd)"),
  choice(MEMBER(controller.rate_reference), "controller", "rate_reference", rate_reference_names, "what the roll rate is compared with: zero, or the reference angle as printed"),
  number(MEMBER(controller.canard_limit), "controller", "canard_limit_deg", "deg", 9, {0.5F, 20}, "plan limit of each canard"),
  choice(MEMBER(controller.entry), "controller", "entry", control_entry_names, "roll angle to begin with: the reference, or the same one whole turns away that is reached soonest"),

  list(offsetof(Plan, gain_schedule.speeds_count), number(LIST(gain_schedule.speeds_m_s), "gain_schedule", "speeds_m_s", "m/s", 0, {0, 1000}, "speeds of the rows, increasing; linear between rows, as the end beyond them")),
  list(offsetof(Plan, gain_schedule.factors_count), number(LIST(gain_schedule.factors), "gain_schedule", "factors", "", 1, {0.01F, 100}, "what all gains of the law are multiplied with at each speed")),

  choice(MEMBER(offset.rejection), "offset", "rejection", offset_rejection_names, "against a fin offset: nothing, as published; integral action; or an observer"),
  number(MEMBER(offset.integral_gain_per_s), "offset", "integral_gain_per_s", "1/s", 0.5F, {0.001F, 10}, "canard angle per roll angle error and second (ki)"),
  number(MEMBER(offset.observer_bandwidth_rad_s), "offset", "observer_bandwidth_rad_s", "rad/s", 6, {0.1F, 50}, "how fast an observer follows the offset"),

  number(MEMBER(roll_model.roll_inertia_kg_m2), "roll_model", "roll_inertia_kg_m2", "kg m2", 0, {0, 100}, "an observer's model: roll inertia after burn-out (I)"),
  number(MEMBER(roll_model.reference_area_m2), "roll_model", "reference_area_m2", "m2", 0, {0, 10}, "an observer's model: reference area (A)"),
  number(MEMBER(roll_model.damping_m2), "roll_model", "damping_m2", "m2", 0, {0, 100000}, "an observer's model: roll damping (alpha)"),
  number(MEMBER(roll_model.torque_m), "roll_model", "torque_m", "m", 0, {0, 100000}, "an observer's model: torque constant (beta)"),
  number(MEMBER(roll_model.density_kg_m3), "roll_model", "density_kg_m3", "kg/m3", 1.225F, {0.1F, 2}, "an observer's model: density of the air (rho)"),

  choice(MEMBER(reference.kind), "reference", "kind", reference_kind_names, "the roll programme"),
  number(MEMBER(reference.initial), "reference", "initial_deg", "deg", 0, {-720, 720}, "reference until the first step or the square wave"),
  list(offsetof(Plan, reference.step_times_count), number(LIST(reference.step_times), "reference", "step_times_s", "s", 0, {0, 600}, "steps: when, after control start")),
  list(offsetof(Plan, reference.step_angles_count), number(LIST(reference.step_angles), "reference", "step_angles_deg", "deg", 0, {-720, 720}, "steps: to which roll angle")),
  number(MEMBER(reference.square_wave_begin), "reference", "square_wave_begin_s", "s", 0, {0, 600}, "square wave: first half wave, after control start"),
  number(MEMBER(reference.square_wave_first), "reference", "square_wave_first_deg", "deg", 45, {-720, 720}, "square wave: angle of the first half wave (R0)"),
  number(MEMBER(reference.square_wave_second), "reference", "square_wave_second_deg", "deg", 0, {-720, 720}, "square wave: angle of the second half wave (R1)"),
  number(MEMBER(reference.square_wave_frequency_hz), "reference", "square_wave_frequency_hz", "Hz", 0.1F, {0.01F, 10}, "square wave: whole waves a second (f0)"),

  choice(MEMBER(excitation.form), "excitation", "form", excitation_names, "none, the product chirp as published, or a phase-continuous sweep"),
  number(MEMBER(excitation.amplitude), "excitation", "amplitude_deg", "deg", 4, {0, 20}, "amplitude (A0)"),
  number(MEMBER(excitation.begin), "excitation", "begin_s", "s", 0.4F, {0, 600}, "on from this time after control start"),
  number(MEMBER(excitation.end), "excitation", "end_s", "s", 7, {0, 600}, "off from this time after control start"),
  number(MEMBER(excitation.product_slope_hz_s), "excitation", "product_slope_hz_s", "Hz/s", 2, {-50, 50}, "product form: sin(2 pi (slope t + offset) t)"),
  number(MEMBER(excitation.product_offset_hz), "excitation", "product_offset_hz", "Hz", -10, {-50, 50}, "product form: sin(2 pi (slope t + offset) t)"),
  number(MEMBER(excitation.sweep_first_hz), "excitation", "sweep_first_hz", "Hz", 2, {0.05F, 50}, "sweep form: frequency at the beginning"),
  number(MEMBER(excitation.sweep_last_hz), "excitation", "sweep_last_hz", "Hz", 10, {0.05F, 50}, "sweep form: frequency at the end"),
  number(MEMBER(excitation.amplitude_variation), "excitation", "amplitude_variation_deg", "deg", 0, {0, 10}, "seeded variation of the amplitude"),
  number(MEMBER(excitation.frequency_variation_hz), "excitation", "frequency_variation_hz", "Hz", 0, {0, 10}, "seeded variation of the frequency"),
  integer(MEMBER(excitation.variation_seed), "excitation", "variation_seed", 1, {0, 16777215}, "seed of both variations"),

  choice(CANARD(direction), "canards", "direction", direction_names, "reversed: a positive shaft angle rolls the rocket negatively"),
  number(CANARD(trim), "canards", "trim_deg", "deg", 0, {-5, 5}, "shaft angle at which the canard makes no roll moment"),
  number(CANARD(pulse_centre_us), "canards", "pulse_centre_us", "us", 1500, {900, 2100}, "servo pulse at shaft angle zero"),
  number(CANARD(pulse_per_radian_us), "canards", "pulse_per_degree_us", "us/deg", 10, {-40, 40}, "servo pulse per degree of shaft angle"),
  number(CANARD(encoder_zero), "canards", "encoder_zero_deg", "deg", 0, {-180, 180}, "encoder reading at shaft angle zero"),
  number(CANARD(mechanical_stop), "canards", "mechanical_stop_deg", "deg", 25, {1, 45}, "shaft angle of the mechanical stop, either side"),
  number(MEMBER(canards.first_motion_rate_rad_s), "canards", "first_motion_rate_deg_s", "deg/s", 30, {5, 120}, "largest rate of the first motion after power-up"),

  number(MEMBER(monitor.servo_lag), "monitor", "servo_lag_s", "s", 0.025F, {0.001F, 0.2F}, "expected first-order lag of the servo"),
  number(MEMBER(monitor.tracking_limit), "monitor", "tracking_limit_deg", "deg", 3, {0.2F, 20}, "largest difference between expected and measured canard angle"),
  number(MEMBER(monitor.disagreement_limit), "monitor", "disagreement_limit_deg", "deg", 1.5F, {0.2F, 20}, "largest difference between a canard and the middle of the others"),
  number(MEMBER(monitor.hold), "monitor", "hold_s", "s", 0.1F, {0.01F, 2}, "a difference must last this long to be a fault"),
  number(MEMBER(monitor.encoder_timeout), "monitor", "encoder_timeout_s", "s", 0.02F, {0.005F, 1}, "an encoder silent for this long is dead"),

  number(MEMBER(recording.threshold_m_s2), "recording", "threshold_g", "g", 2, {1.2F, 15}, "a specific force beyond this is recorded, whether or not a launch is detected"),
});
#undef MEMBER
#undef LIST
#undef CANARD
// clang-format on

}  // namespace fantail::core::plan_table
