// SPDX-License-Identifier: MIT
#include "core/flight_plan_fields.hpp"
#include "core/flight_plan_table.hpp"

namespace fantail::core {
namespace {

constexpr auto meanings = [] {
  std::array<std::string_view, plan_table::flight_plan_table.size()> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = plan_table::flight_plan_table[i].meaning;
  }
  return result;
}();

}  // namespace

std::string_view meaning(const PlanField& field) {
  return meanings[static_cast<std::size_t>(&field - flight_plan_fields().data())];
}

}  // namespace fantail::core
