// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "faults/campaign.hpp"

namespace fantail::faults {

/// A cell that is asked for, with the grid of its phase; null where the scenario cannot have the fault.
struct Task {
  Cell cell;
  std::shared_ptr<const Grid> grid;
  bool is_not_reached = false;  ///< no flight has time in the phase
};

/// A row of the table after the other, phase by phase. Throws text::Error (usage) for a device or fault that is none.
[[nodiscard]] std::vector<Task> tasks_of(const Campaign& campaign, const Twins& twins);

/// Throws text::Error (bad_configuration), with the reason, for what would fly nothing and be green.
[[nodiscard]] Extent extent_of(const Campaign& campaign, const Twins& twins);

}  // namespace fantail::faults
