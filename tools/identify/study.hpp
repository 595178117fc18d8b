// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identify/identification.hpp"
#include "identify/make_record.hpp"
#include "identify/result/findings.hpp"
#include "logs/roll_log.hpp"

namespace fantail::identify {

struct LagFit {
  double lag_s;      ///< as RecordOptions::lag_s
  bool at_the_edge;  ///< of what was tried: the best may lie beyond
};

inline constexpr double largest_fitted_lag_s = 0.05;

/// The lag of the canard column, within 50 ms, with which the open loop explains the measured angle best: least squared
/// error of the continuous fit, to a tenth of a millisecond. `nodes` are on the log's clock. Throws as make_record and
/// identify do.
[[nodiscard]] LagFit fit_lag(const logs::RollLog& log, const Window& window, const RecordOptions& record_options,
                             const model::Airframe& airframe, const NodeChoice& nodes, const Options& options);

/// What a person wants to know from a log.
struct Question {
  std::vector<Window> windows{};  ///< each is identified by itself
  std::vector<result::Method> methods{result::Method::continuous};
  model::Airframe airframe{};
  RecordOptions record{};
  /// Of the vehicle, for a log that shows its burn-out; where record.roll_inertia is empty.
  sim::RollInertiaCourse inertia_since_ignition{};
  std::optional<bool> grows_with_mach{};     ///< whether alpha and beta do; empty: unknown
  std::string nodes = "even:1";              ///< as find_nodes reads it
  std::optional<double> told_servo_lag_s{};  ///< what the person expects, beside what the closed loop finds
  bool fit_lag = false;                      ///< instead of record.lag_s; open loop only
  Options options{};                         ///< nodes and method apart
};

/// Fills in data, airframe, warnings and windows. Throws as find_nodes, make_record and identify do.
[[nodiscard]] result::Study study(const logs::RollLog& log, const Question& question);

}  // namespace fantail::identify
