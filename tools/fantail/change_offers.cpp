// SPDX-License-Identifier: MIT
#include <span>
#include <string>
#include <string_view>

#include "core/flight_plan_fields.hpp"
#include "fantail/offers.hpp"
#include "input/scenario_file.hpp"
#include "input/vehicle_file.hpp"

namespace fantail::tool {
namespace {

constexpr std::string_view true_or_false[] = {"true", "false"};

/// One key, as far as it goes with what has been typed.
void add(manual::Offer& offer, std::string_view begun, std::string_view section, std::string_view key,
         std::span<const std::string_view> words) {
  if (section.empty()) {  // a change needs a section
    return;
  }
  const std::string change = std::string{section} + "." + std::string{key} + "=";
  if (!begun.starts_with(change)) {
    offer.words.push_back(change);
    return;
  }
  for (const std::string_view word : words) {
    offer.words.push_back(change + std::string{word});
  }
}

template <typename Thing>
void add_fields(manual::Offer& offer, std::string_view begun, std::span<const input::Field<Thing>> fields) {
  for (const input::Field<Thing>& field : fields) {
    add(offer, begun, field.section, field.key, field.allowed.words);
  }
}

void add_plan(manual::Offer& offer, std::string_view begun) {
  for (const core::PlanField& field : core::flight_plan_fields()) {
    const bool is_flag = field.kind == core::FieldKind::flag;
    add(offer, begun, field.section, field.key, is_flag ? std::span{true_or_false} : field.choices);
  }
}

}  // namespace

manual::Offer changes(std::string_view begun) {
  manual::Offer offer;
  add_plan(offer, begun);
  add_fields(offer, begun, input::vehicle_fields());
  add_fields(offer, begun, input::scenario_fields());
  return offer;
}

manual::Offer changes_of_plan(std::string_view begun) {
  manual::Offer offer;
  add_plan(offer, begun);
  return offer;
}

manual::Offer changes_of_vehicle(std::string_view begun) {
  manual::Offer offer;
  add_fields(offer, begun, input::vehicle_fields());
  return offer;
}

}  // namespace fantail::tool
