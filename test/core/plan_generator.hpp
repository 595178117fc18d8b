// SPDX-License-Identifier: MIT
#pragma once

#include <rapidcheck.h>

#include "core/flight_plan_fields.hpp"
#include "known_roll_model.hpp"

namespace fantail::core {

/// A number of the field's own grid of a thousand steps, its ends as likely as its inside.
inline float arbitrary_value(const PlanField& field) {
  if (field.kind != FieldKind::number) {
    const auto last = static_cast<int>(field.maximum);
    return static_cast<float>(*rc::gen::inRange(static_cast<int>(field.minimum), last + 1));
  }
  const int step = *rc::gen::oneOf(rc::gen::element(0, 1000), rc::gen::inRange(0, 1001));
  const float value = field.minimum + (field.maximum - field.minimum) * (static_cast<float>(step) * 0.001F);
  return step == 1000 ? field.maximum : value;
}

/// Any plan that validate() lets fly. Every field is drawn by itself; a value that breaks a rule with the fields drawn
/// before it is put back to its default, so that no draw is wasted.
inline FlightPlan arbitrary_plan() {
  FlightPlan plan = default_plan();
  const auto steps = *rc::gen::inRange<std::size_t>(1, most_reference_steps + 1);
  for (std::size_t i = 0; i < steps; ++i) {  // lists that only make sense together
    plan.reference.step_times[i] =
        Microseconds{static_cast<std::int64_t>(i) * 70'000'000 + *rc::gen::inRange(0, 70'000'000)};
    plan.reference.step_angles[i] = Angle::from_degrees(static_cast<float>(*rc::gen::inRange(-720, 721)));
  }
  plan.reference.step_times_count = plan.reference.step_angles_count = static_cast<std::uint8_t>(steps);
  const auto rows = *rc::gen::inRange<std::size_t>(0, most_schedule_rows + 1);
  for (std::size_t i = 0; i < rows; ++i) {
    plan.gain_schedule.speeds_m_s[i] = static_cast<float>(100 * i) + static_cast<float>(*rc::gen::inRange(0, 100));
    plan.gain_schedule.factors[i] = 0.01F * static_cast<float>(*rc::gen::inRange(1, 10'001));
  }
  plan.gain_schedule.speeds_count = plan.gain_schedule.factors_count = static_cast<std::uint8_t>(rows);
  plan.roll_model = known_roll_model;
  for (const PlanField& field : flight_plan_fields()) {
    if (field.is_list()) {
      continue;
    }
    const FlightPlan before = plan;
    for (std::size_t slot = 0; slot < field.slots; ++slot) {
      field.set(plan, slot, arbitrary_value(field));
    }
    if (validate(plan)) {
      plan = before;
    }
  }
  return plan;
}

}  // namespace fantail::core
