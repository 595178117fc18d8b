// SPDX-License-Identifier: MIT
#include "core/flight_plan_members.hpp"

#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

#include "core/finite.hpp"
#include "core/flight_plan_table.hpp"

namespace fantail::core {
namespace {

// Without the names: these stay in the table, and out of an image.
constexpr auto members = [] {
  std::array<PlanMember, plan_table::flight_plan_table.size()> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = plan_table::flight_plan_table[i];
  }
  return result;
}();

consteval std::size_t words() {
  std::size_t sum = 0;
  for (const PlanMember& member : members) {
    sum += member.slots + (member.is_list() ? 1U : 0U);
  }
  return sum;
}
static_assert(words() == flight_plan_words, "the header says how many they are, for whoever keeps a plan's block");

// An Angle and a float have the same bytes, and Microseconds those of a 64-bit integer.
static_assert(std::is_trivially_copyable_v<FlightPlan> && std::is_standard_layout_v<FlightPlan>);
static_assert(sizeof(Angle) == sizeof(float) && sizeof(Microseconds) == sizeof(std::int64_t));

template <typename T>
T load(const FlightPlan& plan, std::size_t at) {
  T value;
  std::memcpy(&value, std::as_bytes(std::span{&plan, 1}).subspan(at, sizeof(T)).data(), sizeof(T));
  return value;
}

template <typename T>
void store(FlightPlan& plan, std::size_t at, T value) {
  std::memcpy(std::as_writable_bytes(std::span{&plan, 1}).subspan(at, sizeof(T)).data(), &value, sizeof(T));
}

}  // namespace

std::span<const PlanMember> flight_plan_members() { return members; }

std::size_t PlanMember::used_slots(const FlightPlan& plan) const {
  return has_length ? load<std::uint8_t>(plan, length_offset) : slots;
}

void PlanMember::set_length(FlightPlan& plan, std::size_t length) const {
  store(plan, length_offset, static_cast<std::uint8_t>(length));
}

std::uint32_t PlanMember::get_bits(const FlightPlan& plan, std::size_t slot) const {
  const std::size_t at = place(slot);
  switch (kept) {
    case Kept::choice:
    case Kept::flag: return load<std::uint8_t>(plan, at);
    case Kept::half_word: return load<std::uint16_t>(plan, at);
    case Kept::time: return static_cast<std::uint32_t>(load<std::int64_t>(plan, at));
    case Kept::number:
    case Kept::word: break;
  }
  return load<std::uint32_t>(plan, at);
}

void PlanMember::set_bits(FlightPlan& plan, std::size_t slot, std::uint32_t bits) const {
  const std::size_t at = place(slot);
  switch (kept) {
    case Kept::choice: store(plan, at, static_cast<std::uint8_t>(bits)); return;
    case Kept::flag: store(plan, at, bits != 0); return;
    case Kept::half_word: store(plan, at, static_cast<std::uint16_t>(bits)); return;
    case Kept::time: store(plan, at, std::int64_t{bits}); return;
    case Kept::number:
    case Kept::word: store(plan, at, bits); return;
  }
}

float PlanMember::get_inside(const FlightPlan& plan, std::size_t slot) const {
  if (is_time()) {
    return seconds(Microseconds{load<std::int64_t>(plan, place(slot))});
  }
  const std::uint32_t bits = get_bits(plan, slot);
  return kept == Kept::number ? std::bit_cast<float>(bits) : static_cast<float>(bits);
}

void PlanMember::set(FlightPlan& plan, std::size_t slot, float file_value) const {
  const float inside = file_value * scale;
  if (is_time()) {
    store(plan, place(slot), std::int64_t{from_seconds(inside).count()});
  } else {
    set_bits(plan, slot,
             kept == Kept::number ? std::bit_cast<std::uint32_t>(inside) : static_cast<std::uint32_t>(inside));
  }
}

bool PlanMember::allows(float file_value) const {
  if (!is_finite(file_value) || file_value < minimum || file_value > maximum) {
    return false;
  }
  return kind == FieldKind::number || file_value == static_cast<float>(static_cast<std::int32_t>(file_value));
}

FlightPlan default_plan() {
  FlightPlan plan{};
  for (const PlanMember& member : members) {
    for (std::size_t slot = 0; slot < member.slots; ++slot) {
      member.set(plan, slot, member.default_value);
    }
  }
  return plan;
}

}  // namespace fantail::core
