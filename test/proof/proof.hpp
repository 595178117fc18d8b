// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/angle.hpp"
#include "core/state_visitor.hpp"
#include "core/time.hpp"

// Of the prover: a value of each type that may be any.
float nondet_float();
bool nondet_bool();
std::uint8_t nondet_u8();
std::uint16_t nondet_u16();
std::uint32_t nondet_u32();
std::int64_t nondet_i64();
void __ESBMC_assume(bool);
void __ESBMC_assert(bool, const char*);

namespace fantail::proof {

inline void assume(bool condition) { __ESBMC_assume(condition); }

// CLAIM: what is proved. REACHABLE: a numbered place of the harness and what holds there in at least one run; without
// it a claim could be true because nothing ever gets there. prove.py looks at the places one at a time, without the
// claims.
#ifdef PROOF_REACHABLE
#define CLAIM(condition) ((void)0)
#define REACHABLE(number, condition) \
  if constexpr ((number) == PROOF_REACHABLE) __ESBMC_assert(!(condition), "reached")
#else
#define CLAIM(condition) __ESBMC_assert(condition, "claim: " #condition)
#define REACHABLE(number, condition) ((void)0)
#endif

inline core::Microseconds any_time() { return core::Microseconds{nondet_i64()}; }
/// Within 140 years of the clock's start, so that no difference of two overflows.
inline core::Microseconds any_instant() {
  const std::int64_t us = nondet_i64();
  assume(us > -(std::int64_t{1} << 52U) && us < (std::int64_t{1} << 52U));
  return core::Microseconds{us};
}
inline core::Angle any_angle() { return core::Angle::from_radians(nondet_float()); }
template <typename Enum>
Enum any_of(unsigned count) {
  const std::uint8_t value = nondet_u8();
  assume(value < count);
  return static_cast<Enum>(value);
}
inline std::optional<core::Angle> any_optional_angle() {
  return nondet_bool() ? std::optional{any_angle()} : std::nullopt;
}

/// Makes each value that an object remembers any value that its type can have.
struct Anything {
  void operator()(float& v) { v = nondet_float(); }
  void operator()(bool& v) { v = nondet_bool(); }
  void operator()(std::uint8_t& v) { v = nondet_u8(); }
  void operator()(std::uint32_t& v) { v = nondet_u32(); }
  void operator()(core::Microseconds& v) { v = any_instant(); }
  void operator()(core::Angle& v) { v = any_angle(); }
  template <typename T>
  void operator()(std::optional<T>& v) {
    if (nondet_bool()) {
      T value{};
      (*this)(value);
      v = value;
    } else {
      v.reset();
    }
  }
  template <typename T, std::size_t n>
  void operator()(std::array<T, n>& v) {
    for (std::size_t i = 0; i < n; ++i) {
      (*this)(v[i]);
    }
  }
  template <core::RemembersState<Anything> T>
  void operator()(T& v) {
    v.visit_state(*this);
  }
  template <typename A, typename B, typename... More>
  void operator()(A& a, B& b, More&... more) {
    (*this)(a);
    (*this)(b, more...);
  }
  template <typename T>
  void below(std::size_t limit, T& v) {
    const std::uint8_t value = nondet_u8();
    assume(value < limit);
    v = static_cast<T>(value);
  }
};

}  // namespace fantail::proof
