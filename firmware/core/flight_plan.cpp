// SPDX-License-Identifier: MIT
#include "core/flight_plan.hpp"

#include "core/finite.hpp"
#include "core/flight_plan_fields.hpp"

namespace fantail::core {
namespace {

// The longest hold whose whole window the motion estimator still integrates.
constexpr Microseconds longest_replayed_hold{500'000};

// What a hobby servo understands, and what the servo driver refuses to go beyond.
constexpr float shortest_pulse_us = 500.0F;
constexpr float longest_pulse_us = 2500.0F;

const PlanField& field_named(std::string_view section, std::string_view key) {
  const auto all = flight_plan_fields();
  for (const PlanField& field : all) {
    if (field.section == section && field.key == key) {
      return field;
    }
  }
  return all.front();
}

std::optional<PlanFault> check_steps(const ReferencePlan& reference) {
  const PlanField& times = field_named("reference", "step_times_s");
  if (reference.step_times_count != reference.step_angles_count) {
    return PlanFault{&times, 0, "step_times_s and step_angles_deg must have the same length"};
  }
  if (reference.kind == ReferenceKind::steps && reference.step_times_count == 0) {
    return PlanFault{&times, 0, "kind = \"steps\" needs at least one step"};
  }
  for (std::size_t i = 1; i < reference.step_times_count; ++i) {
    if (reference.step_times[i] <= reference.step_times[i - 1]) {
      return PlanFault{&times, i, "step times must increase"};
    }
  }
  return std::nullopt;
}

// A limit as the plan itself would keep it, so that a value at its own limit is never refused for a rounding error.
float as_kept(const PlanField& field, float file_value) {
  FlightPlan scratch{};
  field.set(scratch, 0, file_value);
  return field.get_inside(scratch, 0);
}

// Rules that no single range can express.
std::optional<PlanFault> check_across_fields(const FlightPlan& plan) {
  if (plan.motion.height_origin != HeightOrigin::from_detection && plan.launch_detection.hold > longest_replayed_hold) {
    return PlanFault{&field_named("launch_detection", "hold_s"), 0,
                     "must not exceed 0.5 s: height_origin \"replay\" and \"velocity_only\" look back no further"};
  }
  if (plan.excitation.form != ExcitationForm::none && plan.excitation.end <= plan.excitation.begin) {
    return PlanFault{&field_named("excitation", "end_s"), 0, "must be later than begin_s"};
  }
  for (std::size_t i = 0; i < canard_count; ++i) {
    const CanardPlan& canard = plan.canards.each[i];
    if (abs(canard.trim) >= plan.controller.canard_limit) {
      return PlanFault{&field_named("canards", "trim_deg"), i, "must lie inside controller.canard_limit_deg"};
    }
    if (canard.mechanical_stop < plan.controller.canard_limit) {
      return PlanFault{&field_named("canards", "mechanical_stop_deg"), i,
                       "must not be smaller than controller.canard_limit_deg"};
    }
    if (canard.pulse_per_radian_us > -1.0F && canard.pulse_per_radian_us < 1.0F) {
      return PlanFault{&field_named("canards", "pulse_per_degree_us"), i, "must not be zero"};
    }
    const float swing_us = canard.pulse_per_radian_us * plan.controller.canard_limit.radians();
    for (const float pulse_us : {canard.pulse_centre_us - swing_us, canard.pulse_centre_us + swing_us}) {
      if (pulse_us < shortest_pulse_us || pulse_us > longest_pulse_us) {
        return PlanFault{
            &field_named("canards", "pulse_centre_us"), i,
            "with pulse_per_degree_us, some angle inside of controller.canard_limit_deg would need a pulse "
            "outside of 500 to 2500 us, which no servo is given"};
      }
    }
  }
  return check_steps(plan.reference);
}

}  // namespace

bool PlanField::allows(float file_value) const {
  if (!is_finite(file_value) || file_value < minimum || file_value > maximum) {
    return false;
  }
  return kind == FieldKind::number || file_value == static_cast<float>(static_cast<std::int32_t>(file_value));
}

FlightPlan default_plan() {
  FlightPlan plan{};
  for (const PlanField& field : flight_plan_fields()) {
    for (std::size_t slot = 0; slot < field.slots; ++slot) {
      field.set(plan, slot, field.default_value);
    }
  }
  return plan;
}

std::optional<PlanFault> validate(const FlightPlan& plan) {
  for (const PlanField& field : flight_plan_fields()) {
    if (field.used_slots(plan) > field.slots) {
      return PlanFault{&field, 0, "too many values"};
    }
    for (std::size_t slot = 0; slot < field.used_slots(plan); ++slot) {
      const float value = field.get_inside(plan, slot);
      if (!is_finite(value)) {
        return PlanFault{&field, slot, "must be a finite number"};
      }
      if (value < as_kept(field, field.minimum) || value > as_kept(field, field.maximum)) {
        return PlanFault{&field, slot, "out of range"};
      }
    }
  }
  return check_across_fields(plan);
}

}  // namespace fantail::core
