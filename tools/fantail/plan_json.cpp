// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>

#include <fmt/core.h>

#include "core/flight_plan_fields.hpp"
#include "fantail/plan_check.hpp"

namespace fantail::tool {
namespace {

json::Value field_value(const core::PlanField& field, const core::FlightPlan& plan, std::size_t slot) {
  const float value = field.get(plan, slot);
  switch (field.kind) {
    case core::FieldKind::flag: return value != 0.0F;
    case core::FieldKind::choice: return field.choices[static_cast<std::size_t>(value)];
    case core::FieldKind::integer: return static_cast<std::int64_t>(value);
    case core::FieldKind::number: break;
  }
  // The shortest decimal that reads back as the same single-precision number.
  return json::parse(fmt::format("{}", value));
}

}  // namespace

json::Value plan_json(const core::FlightPlan& plan) {
  json::Value json;
  for (const core::PlanField& field : core::flight_plan_fields()) {
    auto& place = json[field.section][field.key];
    if (field.slots == 1) {
      place = field_value(field, plan, 0);
      continue;
    }
    place = json::Value::array();
    for (std::size_t slot = 0; slot < field.used_slots(plan); ++slot) {
      place.push_back(field_value(field, plan, slot));
    }
  }
  return json;
}

}  // namespace fantail::tool
