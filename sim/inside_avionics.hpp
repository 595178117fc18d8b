// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/avionics.hpp"

// What the avionics keeps to itself, for who damages it and for who leaves out of its tick what nobody looks at. The
// one way that the language has to name a private member is an explicit instantiation:
//
//   struct Plan {
//     using Pointer = core::FlightPlan Avionics::*;
//     friend Pointer member(Plan tag);
//   };
//   template struct Open<Plan, &Avionics::plan_>;
//   of<Plan>(avionics)
namespace fantail::sim::inside {

using avionics::Avionics;

template <typename Tag, Tag::Pointer pointer>
struct Open {
  friend Tag::Pointer member(Tag /*tag*/) { return pointer; }
};

template <typename Tag>
auto& of(Avionics& avionics) {
  return avionics.*member(Tag{});
}

template <typename Tag, typename... Arguments>
decltype(auto) call(Avionics& avionics, const Arguments&... arguments) {
  return (avionics.*member(Tag{}))(arguments...);
}

}  // namespace fantail::sim::inside
