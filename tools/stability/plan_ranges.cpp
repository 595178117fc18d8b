// SPDX-License-Identifier: MIT
#include "stability/plan_ranges.hpp"

#include <stdexcept>
#include <string>

#include "core/flight_plan_fields.hpp"

namespace fantail::stability {

PlanRange plan_range(std::string_view section, std::string_view key) {
  for (const core::PlanField& field : core::flight_plan_fields()) {
    if (field.section == section && field.key == key) {
      return {.minimum = static_cast<double>(field.minimum * field.scale),
              .maximum = static_cast<double>(field.maximum * field.scale)};
    }
  }
  throw std::logic_error{"a plan has no " + std::string{section} + "." + std::string{key}};
}

}  // namespace fantail::stability
