// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "campaign/spread.hpp"
#include "campaign/unit_points.hpp"

namespace fantail::campaign {

/// What one run draws.
struct Draw {
  std::vector<double> numbers{};           ///< one a field of each spread, in their order, before their effect
  std::vector<input::Override> changes{};  ///< of the run's files, likewise
  std::size_t drawn_again = 0;             ///< how often a law left what a field allows
};

/// Draws the unknown quantities of every run. The same run draws the same in every order and on every machine.
class Drawer {
 public:
  /// `runs`: as UnitPoints. Throws text::Error (bad_configuration) for more dimensions than `sobol` has.
  Drawer(std::vector<Spread> spreads, Sampling sampling, std::uint64_t master_seed, std::uint64_t runs);

  /// Throws text::Error (bad_configuration) for a value that its field does not allow, naming run, field, value, range,
  /// and the spread's place; with Outside::truncate when a thousand draws in a row left it.
  [[nodiscard]] Draw draw(std::uint64_t run) const;

 private:
  std::vector<Spread> spreads_;
  UnitPoints points_;
  std::uint64_t master_seed_;
};

}  // namespace fantail::campaign
