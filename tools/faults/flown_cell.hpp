// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "faults/fault_table.hpp"
#include "faults/judge.hpp"
#include "sim/scenario.hpp"

namespace fantail::faults {

/// A device, a fault and a phase of the flight.
struct Cell {
  const FaultRow* row = nullptr;
  Phase phase = Phase::pad;

  [[nodiscard]] std::string name() const;  ///< imu/dead/controlling
  [[nodiscard]] const Expected& expected() const { return row->expect(phase); }
  /// What is safe, with what a failed servo may do meanwhile.
  [[nodiscard]] std::string safe() const;
};

/// The cell of a name. Throws text::Error (usage) that says what is allowed.
[[nodiscard]] Cell cell_of(const std::string& name);

/// A scenario with the flight of each of its seeds without any fault.
struct Twins {
  sim::Scenario scenario;            ///< its own faults are flown by the twins, too
  std::vector<std::uint64_t> seeds;  ///< the first is the scenario's own
  std::vector<Twin> twins;           ///< one a seed
  Limits limits;
};

/// Flies them. Throws text::Error (bad_configuration) when one is not armed or never controls: then no phase can be
/// told from another.
[[nodiscard]] Twins fly_twins(const sim::Scenario& scenario, std::size_t seeds);

/// When the phase ends, in ms after ignition: with the seed with which it ends first.
[[nodiscard]] int end_of(Phase phase, const Twins& twins);

/// The grid of one cell: onsets by step, for every seed.
class Grid {
 public:
  /// Every `every`-th onset of the steps within the phase, seed by seed, and at least three a phase.
  Grid(const Twins& twins, Phase phase, int step_ms, int every);

  [[nodiscard]] std::uint64_t size() const { return runs_.size(); }
  struct Run {
    std::size_t seed = 0;  ///< which of the twins
    int begin_ms = 0;      ///< after ignition
  };
  [[nodiscard]] const Run& operator[](std::uint64_t run) const { return runs_[run]; }

 private:
  std::vector<Run> runs_{};
};

/// The scenario of one run: what a flight of it alone needs.
[[nodiscard]] sim::Scenario scenario_of(const Twins& twins, const Cell& cell, const Grid::Run& run,
                                        std::uint64_t number);

/// Flies it and looks at it.
[[nodiscard]] Findings fly_run(const Twins& twins, const Cell& cell, const Grid::Run& run, std::uint64_t number);

}  // namespace fantail::faults
