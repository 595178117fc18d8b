// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace fantail::campaign {

enum class Sampling : std::uint8_t {
  independent,      ///< every run for itself: the same point with any number of runs
  latin_hypercube,  ///< each dimension cut into as many strata as there are runs, one point in each (McKay, 1979)
  sobol,            ///< Sobol's sequence with the direction numbers of Joe and Kuo (2008), shifted at random
};

/// What Sobol's sequence has here.
inline constexpr std::size_t most_sobol_dimensions = 21;

/// Above 0 and below 1, even in steps of 2^-52.
[[nodiscard]] double open_unit(std::uint64_t random_bits);

/// A coordinate of Sobol's sequence as it is published, without a shift; from 0 on, below 1.
[[nodiscard]] double sobol_coordinate(std::uint64_t run, std::size_t dimension);

/// Points of the unit cube, one a run. Each is computed alone, from the master seed and its number: no run waits for
/// another, in whatever order and on whatever machine they are flown.
class UnitPoints {
 public:
  /// `runs`: how many there will be, 1 or more; it plays a part in `latin_hypercube` only.
  UnitPoints(Sampling sampling, std::uint64_t master_seed, std::uint64_t runs)
      : sampling_{sampling}, master_seed_{master_seed}, runs_{runs} {}

  /// Above 0 and below 1. With `sobol`, `dimension` is below `most_sobol_dimensions`.
  [[nodiscard]] double at(std::uint64_t run, std::size_t dimension) const;

 private:
  Sampling sampling_;
  std::uint64_t master_seed_;
  std::uint64_t runs_;
};

}  // namespace fantail::campaign
