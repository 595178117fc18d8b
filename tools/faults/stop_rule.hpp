// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "faults/campaign.hpp"
#include "faults/fault_table.hpp"
#include "faults/flown_cell.hpp"
#include "sim/scenario.hpp"

namespace fantail::faults {

/// Can three canards balance the fins and the fourth at its stop? They can while 4 fin offsets and the stop, where both
/// turn the same way, are less than 3 plan limits, and the stop is not inside the limit. A canard that stalls counts as
/// at its stall.
class StopRule {
 public:
  /// `fault`, of a servo: at which stop the canard is; one that is at none may come to either.
  StopRule(const sim::Scenario& scenario, const sim::Fault& fault);

  [[nodiscard]] bool is_kept() const { return stop_rad_ >= limit_rad_ && acts_as_rad_ < farthest_rad(); }
  /// Of a rocket that breaks it, and whether another stop would keep it.
  [[nodiscard]] std::string sentence() const;
  /// The nearest stop that a linkage can have: half a degree beyond the plan limit.
  [[nodiscard]] double nearest_rad() const;
  [[nodiscard]] double stop_rad() const { return stop_rad_; }

 private:
  [[nodiscard]] double farthest_rad() const { return 3.0 * limit_rad_ - 4.0 * offset_rad_; }

  double offset_rad_;  ///< of the fins, at most; below zero: against the stop
  double limit_rad_;
  double stop_rad_;
  double acts_as_rad_;  ///< the stop, or the stall before it
};

/// Of a cell with a limit of one canard: the rule's sentence where it is broken, and what became of the worst red
/// flight when that was flown again with the nearest stop. Empty: of any other cell.
[[nodiscard]] std::string about_stop(const CellResult& cell, const Twins& twins);

}  // namespace fantail::faults
