// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "core/flight_plan_members.hpp"

// The fields of a plan with what people call them. A board does without: who includes this takes the names along.
namespace fantail::core {

/// One field of a flight plan: the single description from which loading, showing and the manual are made.
struct PlanField : PlanMember {
  std::string_view section;                   ///< of a plan file: "run" for [run]
  std::string_view key;                       ///< in its section; ends with its unit, where it has one
  std::string_view unit;                      ///< as it stands in files; empty for a pure number
  std::span<const std::string_view> choices;  ///< of a choice
  std::string_view meaning;                   ///< a phrase for people, without a full stop
};

/// In the order of flight_plan_members().
[[nodiscard]] std::span<const PlanField> flight_plan_fields();

/// As the end of "... is refused: ".
[[nodiscard]] std::string_view sentence(PlanRule rule);

}  // namespace fantail::core
