// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/flight_plan.hpp"

namespace fantail::core {

enum class FieldKind : std::uint8_t { number, integer, choice, flag };

/// One field of a flight plan, or one per canard, or a list: the single description from which loading, checking,
/// showing, packing and the manual are made. Numbers are in `unit`; a choice is the index into `choices`; a flag 0
/// or 1.
struct PlanField {
  std::string_view section;
  std::string_view key;
  std::string_view unit;  ///< as it stands in files; empty for a pure number
  FieldKind kind = FieldKind::number;
  float default_value = 0.0F;
  float minimum = 0.0F;
  float maximum = 0.0F;
  std::span<const std::string_view> choices;
  std::size_t slots = 1;    ///< 1; 4 for one value a canard; the capacity of a list
  float scale = 1.0F;       ///< inside value = file value * scale
  bool is_time = false;     ///< kept in whole microseconds, which are also its bits
  bool has_length = false;  ///< it is a list; GCC 12's sanitizer takes no `get_length != nullptr` for a constant
  float (*get_inside)(const FlightPlan&, std::size_t slot) = nullptr;
  void (*set_inside)(FlightPlan&, std::size_t slot, float inside) = nullptr;
  std::uint32_t (*get_bits)(const FlightPlan&, std::size_t slot) = nullptr;  ///< exact, for the wire
  void (*set_bits)(FlightPlan&, std::size_t slot, std::uint32_t bits) = nullptr;
  std::size_t (*get_length)(const FlightPlan&) = nullptr;  ///< a list's own length; null for everything else
  void (*set_length)(FlightPlan&, std::size_t length) = nullptr;

  [[nodiscard]] constexpr bool is_list() const { return has_length; }
  [[nodiscard]] std::size_t used_slots(const FlightPlan& plan) const { return is_list() ? get_length(plan) : slots; }
  [[nodiscard]] float get(const FlightPlan& plan, std::size_t slot) const { return get_inside(plan, slot) / scale; }
  /// False for NaN, beyond the range, or a fraction where an integer, choice or flag stands.
  [[nodiscard]] bool allows(float file_value) const;
  /// The caller has checked allows().
  void set(FlightPlan& plan, std::size_t slot, float file_value) const { set_inside(plan, slot, file_value * scale); }
};

[[nodiscard]] std::span<const PlanField> flight_plan_fields();

/// Of one of the flight_plan_fields(), for a person.
[[nodiscard]] std::string_view meaning(const PlanField& field);

/// The slots of all fields, and a length for each list.
inline constexpr std::size_t flight_plan_words = 91;

[[nodiscard]] FlightPlan default_plan();

/// What is wrong with a plan: the field, which of its slots, and the rule it breaks.
struct PlanFault {
  const PlanField* field;
  std::size_t slot;
  std::string_view rule;
};

/// The first fault, or nothing: the plan may fly.
[[nodiscard]] std::optional<PlanFault> validate(const FlightPlan& plan);

}  // namespace fantail::core
