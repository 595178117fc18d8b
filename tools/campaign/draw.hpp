// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "campaign/spread.hpp"

namespace fantail::campaign {

/// A coordinate of the point of the unit cube by which a run draws: above 0 and below 1, even in steps of 2^-52. It is
/// the same with any number of runs, in whatever order and on whatever machine they are flown.
[[nodiscard]] double unit_coordinate(std::uint64_t master_seed, std::uint64_t run, std::size_t dimension);

/// What one run draws.
struct Draw {
  std::vector<double> numbers{};           ///< one a field of each spread, in their order, before their effect
  std::vector<input::Override> changes{};  ///< of the run's files, likewise
  std::size_t drawn_again = 0;             ///< how often a law left what a field allows
};

/// Draws the unknown quantities of every run. The same run draws the same in every order and on every machine.
class Drawer {
 public:
  Drawer(std::vector<Spread> spreads, std::uint64_t master_seed)
      : spreads_{std::move(spreads)}, master_seed_{master_seed} {}

  /// Throws text::Error (bad_configuration) for a value that its field does not allow, naming run, field, value, range,
  /// and the spread's place; with Outside::truncate when a thousand draws in a row left it.
  [[nodiscard]] Draw draw(std::uint64_t run) const;

  /// How many independent standard normal numbers make a draw, whatever its laws.
  [[nodiscard]] std::size_t dimensions() const;
  /// The draw of dimensions() of them: independent ones have the laws of the spreads. Empty where it leaves what a
  /// field allows. Throws as draw() does for a spread that refuses it.
  [[nodiscard]] std::optional<Draw> draw_at(std::span<const double> normals) const;

 private:
  std::vector<Spread> spreads_;
  std::uint64_t master_seed_;
};

}  // namespace fantail::campaign
