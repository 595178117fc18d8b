// SPDX-License-Identifier: MIT
#include "core/flight_plan.hpp"

#include "core/finite.hpp"
#include "core/flight_plan_members.hpp"
#include "core/flight_plan_table.hpp"

namespace fantail::core {
namespace {

// The longest hold whose whole window the motion estimator still integrates.
constexpr Microseconds longest_replayed_hold{500'000};

// What a hobby servo understands, and what the servo driver refuses to go beyond.
constexpr float shortest_pulse_us = 500.0F;
constexpr float longest_pulse_us = 2500.0F;

consteval std::size_t place(std::string_view section, std::string_view key) {
  std::size_t i = 0;
  while (plan_table::flight_plan_table.at(i).section != section || plan_table::flight_plan_table.at(i).key != key) {
    ++i;
  }
  return i;
}

std::optional<PlanFault> check_steps(const ReferencePlan& reference) {
  constexpr std::size_t times = place("reference", "step_times_s");
  if (reference.step_times_count != reference.step_angles_count) {
    return PlanFault{times, 0, PlanRule::lists_of_one_length};
  }
  if (reference.kind == ReferenceKind::steps && reference.step_times_count == 0) {
    return PlanFault{times, 0, PlanRule::steps_are_there};
  }
  for (std::size_t i = 1; i < reference.step_times_count; ++i) {
    if (reference.step_times[i] <= reference.step_times[i - 1]) {
      return PlanFault{times, i, PlanRule::steps_increase};
    }
  }
  return std::nullopt;
}

bool knows_speed(const FlightPlan& plan) {
  return plan.run.start == Start::launch && plan.motion.height_origin != HeightOrigin::from_detection;
}

std::optional<PlanFault> check_schedule(const FlightPlan& plan) {
  constexpr std::size_t speeds = place("gain_schedule", "speeds_m_s");
  const GainSchedulePlan& schedule = plan.gain_schedule;
  if (schedule.speeds_count != schedule.factors_count) {
    return PlanFault{speeds, 0, PlanRule::schedule_of_one_length};
  }
  for (std::size_t i = 1; i < schedule.speeds_count; ++i) {
    if (schedule.speeds_m_s[i] <= schedule.speeds_m_s[i - 1]) {
      return PlanFault{speeds, i, PlanRule::schedule_speeds_increase};
    }
  }
  if (schedule.speeds_count > 0 && !knows_speed(plan)) {
    return PlanFault{speeds, 0, PlanRule::speed_is_known};
  }
  return std::nullopt;
}

std::optional<PlanFault> check_offset_rejection(const FlightPlan& plan) {
  constexpr std::size_t rejection = place("offset", "rejection");
  if (plan.offset.rejection == OffsetRejection::integral && !(plan.controller.proportional_gain > 0.0F)) {
    return PlanFault{rejection, 0, PlanRule::integral_beside_proportional};
  }
  if (plan.offset.rejection != OffsetRejection::observer) {
    return std::nullopt;
  }
  if (!knows_speed(plan)) {
    return PlanFault{rejection, 0, PlanRule::speed_is_known};
  }
  constexpr std::size_t model = place("roll_model", "roll_inertia_kg_m2");
  const RollModelPlan& values = plan.roll_model;
  std::size_t field = model;  // in the order of the table
  for (const float value : {values.roll_inertia_kg_m2, values.reference_area_m2, values.damping_m2, values.torque_m}) {
    if (!(value > 0.0F)) {
      return PlanFault{field, 0, PlanRule::observer_has_model};
    }
    ++field;
  }
  return std::nullopt;
}

bool gates_by_burn_out(DormantUntil until) {
  return until == DormantUntil::burn_out || until == DormantUntil::burn_out_and_height;
}

bool gates_by_height(DormantUntil until) {
  using enum DormantUntil;
  return until == height || until == burn_out_and_height || until == max_dynamic_pressure_and_height;
}

std::optional<PlanFault> check_dormancy(const FlightPlan& plan) {
  const DormancyPlan& dormancy = plan.dormancy;
  if (dormancy.until == DormantUntil::guide) {
    return std::nullopt;
  }
  if (!knows_speed(plan)) {
    return PlanFault{place("dormancy", "until"), 0, PlanRule::gate_is_measured};
  }
  if (gates_by_burn_out(dormancy.until) && !(dormancy.burn_time > Microseconds{0})) {
    return PlanFault{place("dormancy", "burn_time_s"), 0, PlanRule::burn_out_has_time};
  }
  if (gates_by_height(dormancy.until) && !(dormancy.height_m > plan.guide.length_m + plan.guide.clearance_m)) {
    return PlanFault{place("dormancy", "height_m"), 0, PlanRule::height_beyond_guide};
  }
  return std::nullopt;
}

std::optional<PlanFault> check_capture(const FlightPlan& plan) {
  constexpr std::size_t entry = place("controller", "entry");
  if (plan.controller.entry != ControlEntry::capture) {
    return std::nullopt;
  }
  if (!knows_speed(plan)) {
    return PlanFault{entry, 0, PlanRule::speed_is_known};
  }
  if (!(plan.controller.proportional_gain > 0.0F) || plan.controller.rate_reference != RateReference::zero) {
    return PlanFault{entry, 0, PlanRule::capture_turns_back};
  }
  const RollModelPlan& model = plan.roll_model;
  int given = 0;
  for (const float value : {model.roll_inertia_kg_m2, model.reference_area_m2, model.damping_m2, model.torque_m}) {
    given += value > 0.0F ? 1 : 0;
  }
  if (given != 0 && given != 4) {
    return PlanFault{entry, 0, PlanRule::capture_model_is_whole};
  }
  return std::nullopt;
}

std::optional<PlanFault> check_mountings(const SensorsPlan& sensors) {
  std::size_t field = place("sensors", "imu_along_y");  // in the order of the table, a pair for each sensor
  for (const SensorMounting& mounting : {sensors.imu, sensors.second_imu, sensors.accelerometer}) {
    if (static_cast<unsigned>(mounting.to_nose) / 2 == static_cast<unsigned>(mounting.along_y) / 2) {
      return PlanFault{field, 0, PlanRule::axes_differ};
    }
    field += 2;
  }
  return std::nullopt;
}

// A limit as the plan itself would keep it, so that a value at its own limit is never refused for a rounding error.
float as_kept(const PlanMember& member, float file_value) {
  const float inside = file_value * member.scale;
  return member.is_time() ? seconds(from_seconds(inside)) : inside;
}

std::optional<PlanFault> check_canard(const FlightPlan& plan, std::size_t i) {
  const CanardPlan& canard = plan.canards.each[i];
  if (abs(canard.trim) >= plan.controller.canard_limit) {
    return PlanFault{place("canards", "trim_deg"), i, PlanRule::trim_within_limit};
  }
  if (canard.mechanical_stop < plan.controller.canard_limit) {
    return PlanFault{place("canards", "mechanical_stop_deg"), i, PlanRule::stop_beyond_limit};
  }
  if (canard.pulse_per_radian_us > -1.0F && canard.pulse_per_radian_us < 1.0F) {
    return PlanFault{place("canards", "pulse_per_degree_us"), i, PlanRule::pulse_turns_servo};
  }
  const float swing_us = canard.pulse_per_radian_us * plan.controller.canard_limit.radians();
  for (const float pulse_us : {canard.pulse_centre_us - swing_us, canard.pulse_centre_us + swing_us}) {
    if (pulse_us < shortest_pulse_us || pulse_us > longest_pulse_us) {
      return PlanFault{place("canards", "pulse_centre_us"), i, PlanRule::pulse_within_servo};
    }
  }
  return std::nullopt;
}

// Rules that no single range can express.
std::optional<PlanFault> check_across_fields(const FlightPlan& plan) {
  if (plan.motion.height_origin != HeightOrigin::from_detection && plan.launch_detection.hold > longest_replayed_hold) {
    return PlanFault{place("launch_detection", "hold_s"), 0, PlanRule::hold_is_replayed};
  }
  if (plan.excitation.form != ExcitationForm::none && plan.excitation.end <= plan.excitation.begin) {
    return PlanFault{place("excitation", "end_s"), 0, PlanRule::excitation_ends_after_it_begins};
  }
  for (std::size_t i = 0; i < canard_count; ++i) {
    if (const auto fault = check_canard(plan, i)) {
      return fault;
    }
  }
  if (const auto fault = check_mountings(plan.sensors)) {
    return fault;
  }
  if (const auto fault = check_schedule(plan)) {
    return fault;
  }
  if (const auto fault = check_offset_rejection(plan)) {
    return fault;
  }
  if (const auto fault = check_dormancy(plan)) {
    return fault;
  }
  if (const auto fault = check_capture(plan)) {
    return fault;
  }
  return check_steps(plan.reference);
}

}  // namespace

std::optional<PlanFault> validate(const FlightPlan& plan) {
  const auto members = flight_plan_members();
  for (std::size_t field = 0; field < members.size(); ++field) {
    const PlanMember& member = members[field];
    if (member.used_slots(plan) > member.slots) {
      return PlanFault{field, 0, PlanRule::too_many_values};
    }
    for (std::size_t slot = 0; slot < member.used_slots(plan); ++slot) {
      const float value = member.get_inside(plan, slot);
      if (!is_finite(value)) {
        return PlanFault{field, slot, PlanRule::finite};
      }
      if (value < as_kept(member, member.minimum) || value > as_kept(member, member.maximum)) {
        return PlanFault{field, slot, PlanRule::in_range};
      }
    }
  }
  return check_across_fields(plan);
}

}  // namespace fantail::core
