// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "avionics/avionics.hpp"

namespace fantail::avionics {

// Where things lie in the avionics, for whoever damages them. The one way that the language has to name a private
// member is an explicit instantiation.

namespace named {

struct Law;
struct Plan;
struct Watch;
struct Flash;
std::optional<core::Autopilot> Avionics::* member(Law* tag);
core::FlightPlan Avionics::* member(Plan* tag);
MemoryWatch Avionics::* member(Watch* tag);
FlashService Avionics::* member(Flash* tag);

template <typename Tag, auto pointer>
struct Open {
  friend auto member(Tag* /*tag*/) -> decltype(pointer) { return pointer; }
};
template struct Open<Law, &Avionics::autopilot_>;
template struct Open<Plan, &Avionics::plan_>;
template struct Open<Watch, &Avionics::memory_watch_>;
template struct Open<Flash, &Avionics::flash_>;

template <typename Tag>
auto& in(Avionics& avionics) {
  return avionics.*member(static_cast<Tag*>(nullptr));
}

}  // namespace named

inline core::Autopilot& law_in(Avionics& avionics) { return *named::in<named::Law>(avionics); }
inline core::FlightPlan& plan_in(Avionics& avionics) { return named::in<named::Plan>(avionics); }
inline MemoryWatch& watch_in(Avionics& avionics) { return named::in<named::Watch>(avionics); }
/// The packed plan: the copy from which all others can be made again.
inline std::span<std::byte> plan_block_in(Avionics& avionics) {
  const auto block = named::in<named::Flash>(avionics).recorder().plan_block();
  return {const_cast<std::byte*>(block.data()), block.size()};  // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

template <typename T>
std::span<std::byte> memory_of(T& value) {
  return std::as_writable_bytes(std::span{&value, 1});
}

}  // namespace fantail::avionics
