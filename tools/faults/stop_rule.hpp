// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "faults/campaign.hpp"
#include "faults/fault_table.hpp"
#include "faults/flown_cell.hpp"
#include "sim/scenario.hpp"

namespace fantail::faults {

/// Can three canards balance the fins and the fourth at its stop? They do while 4 fin offsets and the stop are less
/// than 3 plan limits, and the stop is not inside the limit.
class StopRule {
 public:
  explicit StopRule(const sim::Scenario& scenario);

  [[nodiscard]] bool is_kept() const { return stop_rad_ >= limit_rad_ && stop_rad_ < farthest_rad(); }
  /// Of a rocket that breaks it, and whether another stop would keep it.
  [[nodiscard]] std::string sentence() const;
  /// The nearest stop that a linkage can have: half a degree beyond the plan limit.
  [[nodiscard]] double nearest_rad() const;
  [[nodiscard]] double stop_rad() const { return stop_rad_; }

 private:
  [[nodiscard]] double farthest_rad() const { return 3.0 * limit_rad_ - 4.0 * offset_rad_; }

  double offset_rad_;  ///< of the fins, at most
  double limit_rad_;
  double stop_rad_;
};

/// A limit of one canard far off, which depends on this rule.
[[nodiscard]] bool is_of_one_canard(const KnownLimit& limit);

/// Of a cell that such a limit excuses: the rule's sentence, and what became of its worst flight when that was flown
/// again with the nearest stop. Empty: of any other cell.
[[nodiscard]] std::string about_stop(const CellResult& cell, const Twins& twins);

}  // namespace fantail::faults
