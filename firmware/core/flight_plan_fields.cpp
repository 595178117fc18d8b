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

constexpr std::size_t words() {
  std::size_t sum = 0;
  for (const PlanField& field : fields) {
    sum += field.slots + (field.is_list() ? 1U : 0U);
  }
  return sum;
}
static_assert(words() == flight_plan_words, "the header says how many they are, for whoever keeps a plan's block");

}  // namespace

std::span<const PlanField> flight_plan_fields() { return fields; }

}  // namespace fantail::core
