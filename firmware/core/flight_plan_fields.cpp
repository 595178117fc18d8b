// SPDX-License-Identifier: MIT
#include "core/flight_plan_fields.hpp"

#include "core/flight_plan_table.hpp"

namespace fantail::core {
namespace {

constexpr auto fields = [] {
  std::array<PlanField, plan_table::flight_plan_table.size()> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = plan_table::flight_plan_table[i].field;
  }
  return result;
}();

}  // namespace

std::span<const PlanField> flight_plan_fields() { return fields; }

}  // namespace fantail::core
