// SPDX-License-Identifier: MIT
#include "campaign/unit_points.hpp"

#include <array>
#include <bit>

#include "campaign/seed_of_run.hpp"
#include "sim/random.hpp"

namespace fantail::campaign {
namespace {

/// Of the random numbers of one run; those of the world begin at one.
constexpr std::uint64_t first_stream = 2'000;
/// Of those of the whole campaign.
constexpr std::uint64_t permutation_stream = 1ULL << 62U;
constexpr std::uint64_t shift_stream = permutation_stream + (1ULL << 32U);

std::uint64_t mixed(std::uint64_t value) {  // the finaliser of splitmix64
  value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27U)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31U);
}

/// The place of `index` in a random order of 0 to count - 1. A Feistel network permutes the numbers of an even count of
/// bits; what falls beyond is sent through again, until it falls inside (Black and Rogaway, 2002).
std::uint64_t permuted(std::uint64_t index, std::uint64_t count, std::uint64_t key) {
  constexpr int rounds = 6;
  const auto half = static_cast<unsigned>(std::bit_width(count - 1) + 1) / 2;
  const std::uint64_t mask = (1ULL << half) - 1;
  do {
    std::uint64_t left = index >> half;
    std::uint64_t right = index & mask;
    for (int round = 0; round < rounds; ++round) {
      const std::uint64_t next = left ^ (mixed(right ^ mixed(key + static_cast<std::uint64_t>(round))) & mask);
      left = right;
      right = next;
    }
    index = (left << half) | right;
  } while (index >= count);
  return index;
}

/// One dimension: the inner coefficients of a primitive polynomial as bits, its degree, and as many first numbers.
struct JoeKuo {
  unsigned degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 7> first;
};

// new-joe-kuo-6.21201; its first dimension needs no row.
constexpr std::array<JoeKuo, most_sobol_dimensions - 1> joe_kuo{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
}};

constexpr unsigned sobol_bits = 52;
using Directions = std::array<std::uint64_t, sobol_bits>;  ///< the highest of `sobol_bits` is a half

constexpr Directions directions_of(std::size_t dimension) {
  Directions all{};
  for (unsigned i = 0; i < sobol_bits; ++i) {
    all[i] = 1ULL << (sobol_bits - 1 - i);
  }
  if (dimension == 0) {
    return all;
  }
  const JoeKuo& row = joe_kuo[dimension - 1];
  for (unsigned i = 0; i < sobol_bits; ++i) {
    if (i < row.degree) {
      all[i] *= row.first[i];
      continue;
    }
    all[i] = all[i - row.degree] ^ (all[i - row.degree] >> row.degree);
    for (unsigned k = 1; k < row.degree; ++k) {
      if (((row.coefficients >> (row.degree - 1 - k)) & 1U) != 0) {
        all[i] ^= all[i - k];
      }
    }
  }
  return all;
}

constexpr auto directions = [] {
  std::array<Directions, most_sobol_dimensions> all{};
  for (std::size_t dimension = 0; dimension < all.size(); ++dimension) {
    all[dimension] = directions_of(dimension);
  }
  return all;
}();

// In the order of the Gray code, as the sequence is usually computed.
std::uint64_t sobol(std::uint64_t run, std::size_t dimension) {
  std::uint64_t gray = run ^ (run >> 1U);
  std::uint64_t point = 0;
  for (unsigned bit = 0; gray != 0; ++bit, gray >>= 1U) {
    if ((gray & 1U) != 0) {
      point ^= directions[dimension][bit];
    }
  }
  return point;
}

}  // namespace

// The middle of a step, so that neither 0 nor 1 is ever drawn.
double open_unit(std::uint64_t random_bits) { return (static_cast<double>(random_bits >> 12U) + 0.5) * 0x1p-52; }

double sobol_coordinate(std::uint64_t run, std::size_t dimension) {
  return static_cast<double>(sobol(run, dimension)) * 0x1p-52;
}

double UnitPoints::at(std::uint64_t run, std::size_t dimension) const {
  const std::uint64_t own = sim::Random{key_of_run(master_seed_, run), first_stream + dimension}.bits();
  switch (sampling_) {
    case Sampling::independent: break;
    case Sampling::latin_hypercube: {
      const std::uint64_t key = sim::Random{master_seed_, permutation_stream + dimension}.bits();
      return (static_cast<double>(permuted(run, runs_, key)) + open_unit(own)) / static_cast<double>(runs_);
    }
    case Sampling::sobol: {
      const std::uint64_t shift = sim::Random{master_seed_, shift_stream + dimension}.bits();
      return open_unit((sobol(run, dimension) << (64U - sobol_bits)) ^ shift);
    }
  }
  return open_unit(own);
}

}  // namespace fantail::campaign
