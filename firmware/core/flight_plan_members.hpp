// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/flight_plan.hpp"
#include "core/time.hpp"

namespace fantail::core {

enum class FieldKind : std::uint8_t { number, integer, choice, flag };

/// What a value is inside a plan: a float or an Angle; Microseconds; an enumeration; a bool; 16 bits; 32 bits.
enum class Kept : std::uint8_t { number, time, choice, flag, half_word, word };

/// One field of a flight plan, or one per canard, or a list, without what only a person reads: where it is kept and
/// what it may be. A value in a file has the unit that the field's name ends with; a choice is its index; a flag 0
/// or 1.
struct PlanMember {
  std::uint16_t offset;         ///< of slot 0, from the beginning of a FlightPlan
  std::uint16_t length_offset;  ///< of a list's own length
  std::uint8_t stride;          ///< from slot to slot
  std::uint8_t slots;           ///< 1; 4 for one value a canard; the capacity of a list
  Kept kept;
  bool has_length;  ///< it is a list
  FieldKind kind;
  float default_value;
  float minimum;
  float maximum;
  float scale;  ///< inside value = file value * scale

  [[nodiscard]] constexpr bool is_list() const { return has_length; }
  /// Kept in whole microseconds, which are also its bits.
  [[nodiscard]] constexpr bool is_time() const { return kept == Kept::time; }
  [[nodiscard]] std::size_t used_slots(const FlightPlan& plan) const;
  /// Of a list.
  void set_length(FlightPlan& plan, std::size_t length) const;

  [[nodiscard]] float get_inside(const FlightPlan& plan, std::size_t slot) const;
  [[nodiscard]] float get(const FlightPlan& plan, std::size_t slot) const { return get_inside(plan, slot) / scale; }
  /// False for NaN, beyond the range, or a fraction where an integer, choice or flag stands.
  [[nodiscard]] bool allows(float file_value) const;
  /// The caller has checked allows().
  void set(FlightPlan& plan, std::size_t slot, float file_value) const;

  /// Exact, for the wire.
  [[nodiscard]] std::uint32_t get_bits(const FlightPlan& plan, std::size_t slot) const;
  void set_bits(FlightPlan& plan, std::size_t slot, std::uint32_t bits) const;

 private:
  [[nodiscard]] std::size_t place(std::size_t slot) const { return offset + slot * stride; }
};

/// Every field, in the order of the table.
[[nodiscard]] std::span<const PlanMember> flight_plan_members();

/// The slots of all fields, and a length for each list.
inline constexpr std::size_t flight_plan_words = 122;

[[nodiscard]] FlightPlan default_plan();

enum class PlanRule : std::uint8_t {
  too_many_values,
  finite,
  in_range,
  hold_is_replayed,
  excitation_ends_after_it_begins,
  trim_within_limit,
  stop_beyond_limit,
  pulse_turns_servo,
  pulse_within_servo,
  lists_of_one_length,
  steps_are_there,
  steps_increase,
  schedule_of_one_length,
  schedule_speeds_increase,
  speed_is_known,
  integral_beside_proportional,
  observer_has_model,
  axes_differ,
};

/// What is wrong with a plan: the field by its place in the table, which of its slots, and the rule it breaks.
struct PlanFault {
  std::size_t field;
  std::size_t slot;
  PlanRule rule;
};

/// The first fault, or nothing: the plan may fly.
[[nodiscard]] std::optional<PlanFault> validate(const FlightPlan& plan);

}  // namespace fantail::core
