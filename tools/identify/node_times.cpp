// SPDX-License-Identifier: MIT
#include "identify/node_times.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "sim/input_error.hpp"

namespace fantail::identify {

NodeTimes even_nodes(const Record& record, std::size_t intervals) {
  const double length_s = record.time_s.back();
  NodeTimes times{0.0};
  for (std::size_t k = 1; k <= intervals; ++k) {
    times.push_back(length_s * static_cast<double>(k) / static_cast<double>(intervals));
  }
  return times;
}

NodeShare node_share(const NodeTimes& nodes, double time_s) {
  if (time_s <= nodes.front()) {
    return {.left = 0, .right = 0, .right_share = 0.0};
  }
  const std::size_t last = nodes.size() - 1;
  if (time_s >= nodes.back()) {
    return {.left = last, .right = last, .right_share = 0.0};
  }
  const auto behind = std::ranges::upper_bound(nodes, time_s);
  const auto right = static_cast<std::size_t>(behind - nodes.begin());
  const double begin_s = nodes[right - 1];
  return {.left = right - 1, .right = right, .right_share = (time_s - begin_s) / (nodes[right] - begin_s)};
}

void check_nodes(const Record& record, const NodeTimes& nodes) {
  using sim::InputError;
  using sim::InputFault;
  if (nodes.empty()) {
    throw InputError{InputFault::bad_configuration, "nodes: there is none; allowed: one or more"};
  }
  std::vector<double> weight(nodes.size(), 0.0);
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    if (!(nodes[k] > nodes[k - 1])) {
      throw InputError{InputFault::bad_configuration,
                       fmt::format("nodes: {:g} s after {:g} s; the times must increase", nodes[k], nodes[k - 1])};
    }
  }
  for (const double time_s : record.time_s) {
    const NodeShare share = node_share(nodes, time_s);
    weight[share.left] += 1.0 - share.right_share;
    weight[share.right] += share.right_share;
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (weight[k] <= 0.0) {
      throw InputError{InputFault::bad_configuration,
                       fmt::format("nodes: no sample of window {} tells the one at {:g} s; allowed: 0 to {:g} s",
                                   record.window, nodes[k], record.time_s.back())};
    }
  }
}

}  // namespace fantail::identify
