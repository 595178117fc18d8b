// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan_fields.hpp"
#include "test.hpp"

namespace fantail::core {

/// That the first fault of this plan is of this field, and has a sentence.
inline void expect_fault(const FlightPlan& plan, std::string_view section, std::string_view key, std::size_t slot = 0) {
  const std::optional<PlanFault> fault = validate(plan);
  ASSERT_TRUE(fault.has_value()) << section << "." << key;
  const PlanField& field = flight_plan_fields()[fault->field];
  EXPECT_EQ(std::string{field.section} + "." + std::string{field.key}, std::string{section} + "." + std::string{key});
  EXPECT_EQ(fault->slot, slot);
  EXPECT_FALSE(sentence(fault->rule).empty());
}

}  // namespace fantail::core
