// SPDX-License-Identifier: MIT
#include "sim/changed_plan.hpp"

#include <algorithm>
#include <sstream>
#include <string>

#include "core/flight_plan_fields.hpp"
#include "sim/plan_file.hpp"

namespace fantail::sim {
namespace {

// As a file would have it, value by value: "[section]", then "key = value   # meaning".
Document document_of(const core::FlightPlan& plan) {
  Document document;
  std::istringstream lines{plan_table(plan)};
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('[')) {
      section = line.substr(1, line.find(']') - 1);
    } else if (!line.empty()) {
      document.apply(parse_override(section + "." + line.substr(0, line.find('#'))));
    }
  }
  return document;
}

}  // namespace

core::FlightPlan changed_plan(const core::FlightPlan& plan, std::span<const Override> changes) {
  Document document = document_of(plan);
  for (const Override& change : changes) {
    document.apply(change);
  }
  const core::FlightPlan read = read_plan(document);
  core::FlightPlan result = plan;
  for (const core::PlanField& field : core::flight_plan_fields()) {
    const bool changed = std::ranges::any_of(
        changes, [&](const Override& c) { return c.section == field.section && c.key == field.key; });
    if (!changed) {
      continue;
    }
    if (field.is_list()) {
      field.set_length(result, field.used_slots(read));
    }
    for (std::size_t slot = 0; slot < field.used_slots(read); ++slot) {
      field.set_bits(result, slot, field.get_bits(read, slot));
    }
  }
  return result;
}

}  // namespace fantail::sim
