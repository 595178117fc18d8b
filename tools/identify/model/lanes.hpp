// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

// Arithmetic on four numbers at a time, for the few loops that go through every sample of a record for every alpha.

// A function compiled for wider registers hands such numbers over in other places than one that is not: so whatever
// takes or gives them by value is inlined, always, and the compiler need not warn.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace fantail::identify::model {

inline constexpr std::size_t lanes = 4;

/// Four numbers beside each other, for as long as a loop runs; + - * are those of each lane, so the results do not
/// depend on how many of them a processor takes at a time. Never in memory: where they may lie depends on the registers
/// that a function is compiled for.
using Four [[gnu::vector_size(lanes * sizeof(double))]] = double;

/// Four numbers that lie anywhere: at an address, or what a function is given a reference to.
using FourInMemory [[gnu::vector_size(lanes * sizeof(double)), gnu::aligned(alignof(double)), gnu::may_alias]] = double;
[[nodiscard]] inline FourInMemory& four_at(double* first) { return *reinterpret_cast<FourInMemory*>(first); }
[[nodiscard]] inline const FourInMemory& four_at(const double* first) {
  return *reinterpret_cast<const FourInMemory*>(first);
}

[[nodiscard, gnu::always_inline]] inline Four magnitude(const FourInMemory& numbers) {
  using Bits [[gnu::vector_size(sizeof(Four))]] = std::int64_t;
  const Four all = numbers;
  return reinterpret_cast<Four>(reinterpret_cast<Bits>(all) & INT64_MAX);
}

/// In the order of the lanes.
[[nodiscard]] inline double sum(const FourInMemory& numbers) {
  double all = 0.0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    all += numbers[lane];
  }
  return all;
}

}  // namespace fantail::identify::model

/// Before a function: compiled for the vector registers that every PC of the build has, of two numbers, and for those
/// of four that PCs have had since about 2013; the program takes what its processor has. NumPy does the same. Not with
/// Clang, which hands vectors to what such a function calls in other registers than the called one expects.
#if defined(__x86_64__) && !defined(__clang__)
#define FANTAIL_AS_WIDE_AS_THE_PROCESSOR [[gnu::target_clones("avx2", "default")]]
#else
#define FANTAIL_AS_WIDE_AS_THE_PROCESSOR
#endif
