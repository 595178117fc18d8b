// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
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
  bool stays_at_trim = false;  ///< as the next, of Twins::cell()
  bool may_end = false;

  [[nodiscard]] std::string name() const;  ///< imu/dead/controlling
  [[nodiscard]] Expected expected() const {
    const Expected& stated = row->expect(phase);
    return stays_at_trim ? at_trim(stated) : may_end ? or_ended(stated) : stated;
  }
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
  bool stay_at_trim = false;  ///< the plan's gate opens with none of the seeds: nothing but canards at trim is safe

  /// What is safe in it goes by the plan, too.
  [[nodiscard]] Cell cell(const FaultRow& row, Phase phase) const {
    return {.row = &row,
            .phase = phase,
            .stays_at_trim = stay_at_trim,
            .may_end = ends_for_canards(scenario.plan) && is_of_canard(row)};
  }
};

/// Flies them, on several threads (0: as many as the machine has). `look` is called with how many are done, a few times
/// a second, from this thread; what it throws ends it. Throws text::Error (bad_configuration) when one never
/// controls for another reason than a gate that stays closed with all seeds: then no phase can be told from another.
[[nodiscard]] Twins fly_twins(const sim::Scenario& scenario, std::size_t seeds, unsigned threads = 0,
                              const std::function<void(std::size_t done)>& look = {});

/// When the phase ends, in ms after ignition: with the seed with which it ends first.
[[nodiscard]] int end_of(Phase phase, const Twins& twins);

/// The grid of the cells of one phase: onsets by step, for every seed. Runs are found, not kept.
class Grid {
 public:
  /// Every `every`-th onset of the steps within the phase, seed by seed, and at least three a
  /// phase, or all where it has fewer.
  Grid(const Twins& twins, Phase phase, int step_ms, int every);

  [[nodiscard]] std::uint64_t size() const { return size_; }
  struct Run {
    std::size_t seed = 0;  ///< which of the twins
    int begin_ms = 0;      ///< after ignition
  };
  [[nodiscard]] Run operator[](std::uint64_t run) const;

 private:
  struct Row {
    std::uint64_t first = 0;  ///< run of this seed
    int begin_ms = 0;
    int stride_ms = 0;
  };
  std::vector<Row> rows_{};  ///< one a seed
  std::uint64_t size_ = 0;
};

/// The scenario of one run: what a flight of it alone needs.
[[nodiscard]] sim::Scenario scenario_of(const Twins& twins, const Cell& cell, const Grid::Run& run,
                                        std::uint64_t number);

/// Flies it and looks at it.
[[nodiscard]] Findings fly_run(const Twins& twins, const Cell& cell, const Grid::Run& run, std::uint64_t number);

}  // namespace fantail::faults
