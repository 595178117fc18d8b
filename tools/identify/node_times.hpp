// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "identify/estimate.hpp"
#include "identify/record.hpp"

namespace fantail::identify {

/// `intervals` + 1 nodes at an even distance over the record; one node for none.
[[nodiscard]] NodeTimes even_nodes(const Record& record, std::size_t intervals);

/// Throws sim::InputError (bad_configuration) unless the times increase and every node has a sample on one of its
/// sides, this node's side included: another could have any value. `samples_per_node` at least, on average, else
/// bad_data.
void check_nodes(const Record& record, const NodeTimes& nodes);

/// Share of each node in the disturbance at a time; they add up to one.
struct NodeShare {
  std::size_t left;   ///< the node before; its share is 1 - right_share
  std::size_t right;  ///< the node behind; the same as `left` outside the nodes
  double right_share;
};
[[nodiscard]] NodeShare node_share(const NodeTimes& nodes, double time_s);

}  // namespace fantail::identify
