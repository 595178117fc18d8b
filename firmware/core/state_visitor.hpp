// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::core {

// How the flight law shows what it remembers. Every class of the law that remembers something from one tick to the next
// has a member
//
//   template <typename Visitor> void visit_state(Visitor& visit);
//
// that names each remembered value once, in a fixed order, to a visitor that may read or replace it: `visit(a, b, ...)`
// for numbers, times, angles, flags, optionals and arrays of these, and for parts that have a visit_state of their own;
// `visit.below(limit, a, ...)` for enumerations and indices, which are always smaller than `limit`;
// `visit.on_pad(a, ...)` for what is of no use once the rocket flies, and must not be believed by a law that has it as
// it was made. What the plan
// determines is not state. A law that was made from the same plan and given the same state goes on bit for bit: a
// flight log holds such states, and a replay begins at one.

/// A part with a visit_state of its own.
template <typename T, typename Visitor>
concept RemembersState = requires(T& value, Visitor& visitor) { value.visit_state(visitor); };

}  // namespace fantail::core
