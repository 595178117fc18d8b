// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/flight_plan.hpp"
#include "core/time.hpp"

namespace fantail::core {

/// What a value is in a file.
enum class FieldKind : std::uint8_t {
  number,   ///< any within its range
  integer,  ///< whole ones
  choice,   ///< a name of a list, here by its index
  flag,     ///< true or false, here 1 or 0
};

/// What a value is inside a plan.
enum class Kept : std::uint8_t {
  number,     ///< a float, or an Angle, which has the same bytes
  time,       ///< Microseconds
  choice,     ///< an enumeration of 8 bits
  flag,       ///< a bool
  half_word,  ///< 16 bits, unsigned
  word,       ///< 32 bits, unsigned
};

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
  float default_value;  ///< of every slot, in the unit of a file
  float minimum;        ///< in the unit of a file, and allowed itself
  float maximum;        ///< the same
  float scale;          ///< inside value = file value * scale

  /// Then the plan says how many of the slots are in use.
  [[nodiscard]] constexpr bool is_list() const { return has_length; }
  /// Kept in whole microseconds, which are also its bits.
  [[nodiscard]] constexpr bool is_time() const { return kept == Kept::time; }
  /// `slots`, or the length of the list in this plan: beyond `slots` only in a plan that validate() refuses.
  [[nodiscard]] std::size_t used_slots(const FlightPlan& plan) const;
  /// Of a list.
  void set_length(FlightPlan& plan, std::size_t length) const;

  /// In seconds, radians, or as the law has it otherwise. Here and below nothing checks that `slot` is smaller than
  /// `slots`.
  [[nodiscard]] float get_inside(const FlightPlan& plan, std::size_t slot) const;
  /// In the unit of a file: what set() was given, but for rounding.
  [[nodiscard]] float get(const FlightPlan& plan, std::size_t slot) const { return get_inside(plan, slot) / scale; }
  /// False for NaN, beyond the range, or a fraction where an integer, choice or flag stands.
  [[nodiscard]] bool allows(float file_value) const;
  /// The caller has checked allows().
  void set(FlightPlan& plan, std::size_t slot, float file_value) const;

  /// Exact, for the wire.
  [[nodiscard]] std::uint32_t get_bits(const FlightPlan& plan, std::size_t slot) const;
  /// What does not fit is cut off, or becomes true for a flag, and the range is not checked: whoever has bits from
  /// outside compares get_bits() with them and calls validate().
  void set_bits(FlightPlan& plan, std::size_t slot, std::uint32_t bits) const;

 private:
  [[nodiscard]] std::size_t place(std::size_t slot) const { return offset + slot * stride; }
};

/// Every field, in the order of the table.
[[nodiscard]] std::span<const PlanMember> flight_plan_members();

/// The slots of all fields, and a length for each list.
inline constexpr std::size_t flight_plan_words = 134;

/// Every field at its default; passes validate().
[[nodiscard]] FlightPlan default_plan();

/// What validate() asks of a plan; sentence() has it in words.
enum class PlanRule : std::uint8_t {
  too_many_values,                  ///< a list is no longer than its slots
  finite,                           ///< neither NaN nor infinite
  in_range,                         ///< from PlanMember::minimum to maximum
  hold_is_replayed,                 ///< a hold of launch detection is at most 0.5 s, or height begins at detection
  excitation_ends_after_it_begins,  ///< unless there is none
  trim_within_limit,                ///< a trim lies inside of the plan limit
  stop_beyond_limit,                ///< a mechanical stop does not lie inside of the plan limit
  pulse_turns_servo,                ///< at least 1 us per radian, in either sense
  pulse_within_servo,               ///< from 500 to 2500 us at both ends of the plan limit
  lists_of_one_length,              ///< of the reference: as many angles as times
  steps_are_there,                  ///< a reference of steps has at least one
  steps_increase,                   ///< each time of a step is later than the one before
  schedule_of_one_length,           ///< as many factors as speeds
  schedule_speeds_increase,         ///< each is larger than the one before
  speed_is_known,  ///< a schedule or an observer needs a start by launch, and a height that does not begin at detection
  integral_beside_proportional,  ///< integral action needs a proportional gain above zero
  observer_has_model,            ///< an observer needs inertia, area, damping and torque above zero
  axes_differ,                   ///< of a sensor's mounting, not only in sign
  gate_is_measured,        ///< dormancy beyond the guide needs a start by launch, and a height that does not begin at
                           ///< detection
  burn_out_has_time,       ///< a gate by burn-out needs the motor's burn time
  height_beyond_guide,     ///< a gate by height lies above the end of the guide and its clearance
  capture_turns_back,      ///< capture needs a proportional gain above zero and a rate reference of zero
  capture_model_is_whole,  ///< of inertia, area, damping and torque all or none are above zero
};

/// What is wrong with a plan: the field by its place in the table, which of its slots, and the rule it breaks.
struct PlanFault {
  std::size_t field;  ///< index in flight_plan_members()
  std::size_t slot;   ///< 0 for a rule about the field as a whole
  PlanRule rule;
};

/// The first fault, or nothing: the plan may fly.
[[nodiscard]] std::optional<PlanFault> validate(const FlightPlan& plan);

}  // namespace fantail::core
