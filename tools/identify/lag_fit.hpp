// SPDX-License-Identifier: MIT
#pragma once

#include "identify/identification.hpp"
#include "identify/make_record.hpp"
#include "logs/roll_log.hpp"

namespace fantail::identify {

struct LagFit {
  double lag_s;      ///< as RecordOptions::lag_s
  bool at_the_edge;  ///< of what was tried: the best may lie beyond
};

inline constexpr double largest_fitted_lag_s = 0.05;

/// The lag of the canard column, within 50 ms, with which the open loop explains the measured angle best: least squared
/// error of the continuous fit, to a tenth of a millisecond. Throws as make_record and identify do.
[[nodiscard]] LagFit fit_lag(const logs::RollLog& log, const Window& window, const RecordOptions& record_options,
                             const Airframe& airframe, const NodeChoice& nodes, const Options& options);

}  // namespace fantail::identify
